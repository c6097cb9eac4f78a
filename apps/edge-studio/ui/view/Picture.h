// SPDX-License-Identifier: BSD-3-Clause
// The data and the colours of a picture.
#ifndef studio_Picture_h
#define studio_Picture_h

#include <QVector>
#include <optional>

#include "results/ToneMapping.h"
#include "vtkLookupTable.h"

namespace studio
{
/// One array of a data object in colours.
struct Picture
{
  vtkSmartPointer<vtkDataObject> data;
  QString array;
  vtkSmartPointer<vtkLookupTable> colours;
  QVector<double> isolines;
  bool values = false;               ///< written on planes
  std::optional<Exposure> exposure;  ///< the array has linear red, green and blue, to be shown as a photograph
};
}  // namespace studio

#endif
