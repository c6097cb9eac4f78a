// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for luminance images: an error of one line, or an image with as many values as pixels.
#include "FuzzFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosEXRReader.h"
#include "vtkPointData.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  const std::string path = fuzz::write("image.exr", data, size);
  static fuzz::Reading<vtkKalosEXRReader> reader;
  if (reader.fails(path))
    return 0;
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* luminance = image->GetPointData()->GetArray(vtkKalosArrayNames::Luminance);
  fuzz::require(luminance && luminance->GetNumberOfTuples() == image->GetNumberOfPoints());
  return 0;
}
