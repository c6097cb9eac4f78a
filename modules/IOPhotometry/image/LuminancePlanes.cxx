// SPDX-License-Identifier: BSD-3-Clause
#include "LuminancePlanes.h"

#include <limits>
#include <sstream>
#include <stdexcept>

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkPointData.h"

namespace kalos
{
namespace
{
/** Component of an array as float32; throws at the first value that is no luminance. */
Plane makePlane(const char* channel, vtkDataArray* array, int component, int width, int height)
{
  Plane plane{channel, std::vector<float>(static_cast<std::size_t>(width) * height)};
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(y) * width + x, component);
      // Also false for NaN.
      if (!(value >= 0.0 && value <= static_cast<double>(std::numeric_limits<float>::max())))
      {
        std::ostringstream message;
        message << "pixel (" << x << ", " << y << "): " << array->GetName() << " is " << value
                << "; expected a finite float32 value of at least 0 cd/m2";
        throw std::invalid_argument(message.str());
      }
      plane.samples[static_cast<std::size_t>(height - 1 - y) * width + x] = static_cast<float>(value);
    }
  }
  return plane;
}
}  // namespace

std::vector<Plane> makePlanes(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("image: not one slice of pixels; expected a width x height x 1 image");
  }
  vtkPointData* data = image->GetPointData();
  vtkDataArray* bands = data->GetArray(vtkKalosArrayNames::LuminanceBands);
  vtkDataArray* luminance = data->GetArray(vtkKalosArrayNames::Luminance);
  vtkDataArray* error = data->GetArray(vtkKalosArrayNames::LuminanceStandardError);
  std::vector<Plane> planes;
  if (bands && bands->GetNumberOfComponents() == 3)
  {
    const char* const names[3] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c)
    {
      planes.push_back(makePlane(names[c], bands, c, size[0], size[1]));
    }
  }
  else if (luminance && luminance->GetNumberOfComponents() == 1)
  {
    planes.push_back(makePlane("Y", luminance, 0, size[0], size[1]));
  }
  else
  {
    throw std::invalid_argument("image: no luminance; expected the point array Luminance, 1 component, in cd/m2");
  }
  if (error)
  {
    planes.push_back(makePlane("Y.standardError", error, 0, size[0], size[1]));
  }
  return planes;
}
}  // namespace kalos
