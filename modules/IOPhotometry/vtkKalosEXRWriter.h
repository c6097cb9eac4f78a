// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosEXRWriter
 * @brief   write a luminance image as OpenEXR, float32, unclamped
 *
 * Input: vtkImageData, one slice, with the point arrays of vtkKalosArrayNames.h:
 *
 * - LuminanceBands, 3 comp (cd/m²): `R`, `G`, `B`, linear Rec. 709; 0.2126 R + 0.7152 G + 0.0722 B is cd/m²
 * - Luminance (cd/m²): `Y`, where there are no three bands
 * - LuminanceStandardError (cd/m²): `Y.standardError`, if the array is there
 *
 * Header attributes: chromaticities of Rec. 709 and whiteLuminance = 1, as a pixel value of 1 is 1 cd/m²; software and
 * kalosSeed from the field data KalosVersion and Seed, if they are there. VTK's row 0
 * is at the bottom, OpenEXR's at the top: rows are turned over. ZIP compression, which loses nothing.
 *
 * The file is written beside its place under another name and renamed at the end, so that no half-written image stays.
 *
 * Errors: no FileName, an input without luminance, values that are NaN, infinite, negative or beyond float32 (the
 * message names the pixel) and an unwritable place give an error event; a file that was there before stays as it was.
 */
#ifndef vtkKalosEXRWriter_h
#define vtkKalosEXRWriter_h

#include "vtkKalosIOPhotometryModule.h"
#include "vtkWriter.h"

class vtkImageData;

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosEXRWriter : public vtkWriter
{
public:
  static vtkKalosEXRWriter* New();
  vtkTypeMacro(vtkKalosEXRWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the image. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkKalosEXRWriter();
  ~vtkKalosEXRWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkKalosEXRWriter(const vtkKalosEXRWriter&) = delete;
  void operator=(const vtkKalosEXRWriter&) = delete;
};

#endif
