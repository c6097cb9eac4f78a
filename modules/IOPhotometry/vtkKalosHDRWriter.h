// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosHDRWriter
 * @brief   write a luminance image as a Radiance picture (.hdr, RGBE)
 *
 * Input: vtkImageData, one slice, with the point array Luminance (cd/m²), or LuminanceBands of three components (linear
 * Rec. 709). What Radiance's own tools take for the luminance of a pixel, 179 (0.265 R + 0.670 G + 0.065 B), is the
 * luminance in cd/m²; the ratio of the colours is that of the bands. RGBE keeps 8 bits of the largest colour: grey is
 * within 0.4 % of the input's, pure blue within 5 %, and there is no standard error. vtkKalosEXRWriter keeps
 * everything.
 *
 * View, if set, becomes the header's VIEW, such as "rvu -vtv -vp 0 -1 1 -vd 0 1 0 -vu 0 0 1 -vh 60 -vv 45", which tools
 * such as evalglare read.
 *
 * The file is written beside its place under another name and renamed at the end, so that no half-written image stays.
 *
 * Errors: no FileName, an input without luminance, values that are NaN, infinite, negative or beyond float32 (the
 * message names the pixel), a View of more than one line and an unwritable place give an error event; a file that was
 * there before stays as it was.
 */
#ifndef vtkKalosHDRWriter_h
#define vtkKalosHDRWriter_h

#include <string>  // for View

#include "vtkKalosIOPhotometryModule.h"
#include "vtkWriter.h"

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosHDRWriter : public vtkWriter
{
public:
  static vtkKalosHDRWriter* New();
  vtkTypeMacro(vtkKalosHDRWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the image. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** View options of Radiance; none if empty, as it is by default. */
  vtkSetMacro(View, std::string);
  vtkGetMacro(View, std::string);
  ///@}

protected:
  vtkKalosHDRWriter();
  ~vtkKalosHDRWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;
  std::string View;

private:
  vtkKalosHDRWriter(const vtkKalosHDRWriter&) = delete;
  void operator=(const vtkKalosHDRWriter&) = delete;
};

#endif
