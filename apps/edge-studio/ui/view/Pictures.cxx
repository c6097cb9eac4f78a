// SPDX-License-Identifier: BSD-3-Clause
#include "view/Pictures.h"

#include <cmath>

#include "base/DataSets.h"
#include "common/Wording.h"
#include "results/Colours.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkPointData.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

vtkSmartPointer<vtkLookupTable> tableFor(const QVector<ResultPtr>& results, const Display& display)
{
  if (display.scale == Scale::Photographic)
    return photographicGreys(exposureOf(results, display));
  const auto range = rangeOf(results, display);
  if (isSigned(display.quantity))
    return differenceColours(std::max(std::abs(range[0]), std::abs(range[1])));
  return falseColours(range, display.scale == Scale::Logarithmic, display.colours);
}

bool hasColours(const ResultPtr& result)
{
  for (const NamedSet& set : dataSets(result->data))
    if (vtkDataArray* bands = arrayOf(set.data, Names::LuminanceBands))
      return bands->GetNumberOfComponents() == 3;
  return false;
}

/// Whether the picture shows the surfaces' own colours instead of a scale.
bool isColourPhotograph(const ResultPtr& result, const Display& display)
{
  return display.scale == Scale::Photographic && display.quantity == Quantity::Luminance && hasColours(result);
}
}  // namespace

ShownPictures pictureOf(const ResultPtr& result, const QVector<ResultPtr>& sharing, const Display& display)
{
  ShownPictures shown;
  Picture& picture = shown.first;
  picture.data = result ? result->data : nullptr;
  picture.array = QString::fromLatin1(arrayName(display.quantity));
  picture.colours = tableFor(sharing, display);
  picture.values = display.values;
  if (display.isolines && display.quantity != Quantity::Untrusted)
    picture.isolines = roundValues(rangeOf(sharing, display), display.scale == Scale::Logarithmic, 10);
  if (result && isColourPhotograph(result, display))
  {
    picture.exposure = exposureOf(sharing, display);
    picture.array = QString::fromLatin1(Names::LuminanceBands);
    picture.isolines.clear();  // contours are of one value
  }
  shown.legend = {picture.colours, title(display.quantity), unitOf(display.quantity), {}, picture.isolines};
  return shown;
}

ShownPictures picturesOf(const ResultPtr& result, const ResultPtr& other, const Display& display)
{
  ShownPictures shown = pictureOf(result, {result, other}, display);
  shown.second = shown.first;
  shown.second.data = other->data;
  return shown;
}

Display forImages(Display display)
{
  // A range in lux does not apply to luminance.
  display.automaticRange = display.automaticRange || display.quantity != Quantity::Luminance;
  display.quantity = Quantity::Luminance;
  display.hidden.clear();
  return display;
}

QImage developed(const ResultPtr& image, const Display& display)
{
  auto* data = vtkImageData::SafeDownCast(image->data);
  const int width = data->GetDimensions()[0], height = data->GetDimensions()[1];
  const auto table = tableFor({image}, display);
  const bool colours = isColourPhotograph(image, display);
  const Exposure exposure = colours ? exposureOf({image}, display) : Exposure();
  vtkDataArray *luminance = data->GetPointData()->GetArray(Names::Luminance),
               *bands = data->GetPointData()->GetArray(Names::LuminanceBands);
  QImage picture(width, height, QImage::Format_RGB32);
  for (int row = 0; row < height; ++row)
  {
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(height - 1 - row));
    for (int column = 0; column < width; ++column)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(row) * width + column;
      if (colours)
      {
        double rgb[3];
        bands->GetTuple(pixel, rgb);
        const auto c = photographicColour(rgb, exposure);
        line[column] = qRgb(c[0], c[1], c[2]);
        continue;
      }
      const unsigned char* c = table->MapValue(luminance->GetComponent(pixel, 0));
      line[column] = qRgb(c[0], c[1], c[2]);
    }
  }
  return picture;
}

Legend legendOf(const ResultPtr& image, const Display& display)
{
  return {tableFor({image}, display), title(Quantity::Luminance), unitOf(Quantity::Luminance), {}, {}};
}
}  // namespace studio
