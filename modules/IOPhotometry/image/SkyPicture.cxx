// SPDX-License-Identifier: BSD-3-Clause
#include "SkyPicture.h"

#include <filesystem>
#include <stdexcept>

#include "../base/ErrorCatcher.h"
#include "vtkDataArray.h"
#include "vtkHDRReader.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosEXRReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace kalos
{
namespace
{
constexpr double efficacy = 179.0;  // lm/W, of Radiance
constexpr double shares[3] = {0.265, 0.670, 0.065};

/** VTK's row 0 is at the bottom. */
template <class Luminance>
vtkSmartPointer<vtkFloatArray> rowsOf(vtkImageData* image, const Luminance& luminance)
{
  int size[3];
  image->GetDimensions(size);
  auto rows = vtkSmartPointer<vtkFloatArray>::New();
  rows->SetNumberOfComponents(size[0]);
  rows->SetNumberOfTuples(size[1]);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(size[1] - 1 - y) * size[0] + x;
      rows->SetTypedComponent(y, x, static_cast<float>(luminance(pixel)));
    }
  }
  return rows;
}

template <class Reader>
vtkImageData* read(Reader* reader, const std::string& path)
{
  if (!reader->CanReadFile(path.c_str()))
  {
    return nullptr;
  }
  const scene::ErrorCatcher errors(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors.empty())
  {
    throw std::runtime_error(errors.firstLine());
  }
  return reader->GetOutput();
}
}  // namespace

vtkSmartPointer<vtkFloatArray> readSkyPicture(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw std::runtime_error("no such file; expected a latitude-longitude picture, .exr or .hdr");
  }
  vtkNew<vtkKalosEXRReader> exr;
  if (vtkImageData* image = read(exr.Get(), path))
  {
    vtkDataArray* values = image->GetPointData()->GetArray(vtkKalosArrayNames::Luminance);
    return rowsOf(image, [values](vtkIdType pixel) { return values->GetComponent(pixel, 0); });
  }
  vtkNew<vtkHDRReader> hdr;
  if (vtkImageData* image = read(hdr.Get(), path))
  {
    vtkDataArray* values = image->GetPointData()->GetScalars();
    return rowsOf(image, [values](vtkIdType pixel) {
      double sum = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        sum += efficacy * shares[c] * values->GetComponent(pixel, c);
      }
      return sum;
    });
  }
  throw std::runtime_error(
      "neither OpenEXR nor a Radiance picture; expected a latitude-longitude picture, .exr or .hdr");
}
}  // namespace kalos
