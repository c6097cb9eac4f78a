// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosEXRReader
 * @brief   read a luminance image from OpenEXR
 *
 * Output: vtkImageData, width x height x 1, spacing 1, row 0 at the bottom, with float32 point arrays of
 * vtkKalosArrayNames.h; the size is that of the data window.
 *
 * - channel Y: Luminance, cd/m²
 * - channels R, G and B: LuminanceBands (3 components, linear Rec. 709) and Luminance, cd/m²; the header's
 *   chromaticities tell what they are, Rec. 709 without
 * - channel Y.standardError: LuminanceStandardError, cd/m²
 *
 * Of a file of several parts, the first that has Y, or R, G and B, is read.
 *
 * All values are multiplied by the header's whiteLuminance, if it has one: files by other programs may count in units
 * of it. Channels of any type are read as float32. Values are passed on as they are: no clamp.
 *
 * Errors: a file that is missing, no OpenEXR image, truncated or damaged, too small for its pixels, without those
 * channels (subsampled ones included), or with more than MaximumNumberOfPixels() pixels gives an error event and an
 * empty output.
 */
#ifndef vtkKalosEXRReader_h
#define vtkKalosEXRReader_h

#include "vtkImageAlgorithm.h"
#include "vtkKalosIOPhotometryModule.h"

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosEXRReader : public vtkImageAlgorithm
{
public:
  static vtkKalosEXRReader* New();
  vtkTypeMacro(vtkKalosEXRReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the image. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether the file starts as OpenEXR files do. */
  int CanReadFile(const char* path);

  /** Largest image that is read. */
  static vtkIdType MaximumNumberOfPixels() { return 100000000; }

protected:
  vtkKalosEXRReader();
  ~vtkKalosEXRReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;

private:
  vtkKalosEXRReader(const vtkKalosEXRReader&) = delete;
  void operator=(const vtkKalosEXRReader&) = delete;
};

#endif
