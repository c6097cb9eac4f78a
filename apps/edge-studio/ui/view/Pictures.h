// SPDX-License-Identifier: BSD-3-Clause
// Turns results and display settings into colours and a legend.
#ifndef studio_Pictures_h
#define studio_Pictures_h

#include <QImage>

#include "charts/LegendBar.h"
#include "view/ScenePainter.h"

namespace studio
{
/// The pictures of the view, with one scale for both sides.
struct ShownPictures
{
  Picture first, second;
  Legend legend;
};

/// Of a result, on the scale that all of `sharing` have; its picture has no data where it is null.
ShownPictures pictureOf(const ResultPtr& result, const QVector<ResultPtr>& sharing, const Display& display);

/// A result beside another one.
ShownPictures picturesOf(const ResultPtr& result, const ResultPtr& other, const Display& display);

/// The display settings for an image: those of the scene with luminance as the quantity.
Display forImages(Display display);

/// The image in colours, its top row first. `image` is of vtkKalosLuminanceImage.
QImage developed(const ResultPtr& image, const Display& display);

/// Its legend.
Legend legendOf(const ResultPtr& image, const Display& display);
}  // namespace studio

#endif
