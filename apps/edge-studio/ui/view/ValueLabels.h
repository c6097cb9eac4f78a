// SPDX-License-Identifier: BSD-3-Clause
// Values written in the view: on isolines, and at the points of calculation planes.
#ifndef studio_ValueLabels_h
#define studio_ValueLabels_h

#include <QString>
#include <QVector>

#include "base/Point.h"
#include "vtkProp.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;

namespace studio
{
/// "12.3", "450": three significant digits.
QString shortNumber(double value);

/// One label on the longest line of each value of the contours.
QVector<vtkSmartPointer<vtkProp>> contourLabels(vtkPolyData* contours, const char* array, const Point& lift,
                                                double pixelRatio);

/// At cell centres, of many only of some that are evenly spread in their order.
QVector<vtkSmartPointer<vtkProp>> cellLabels(vtkDataSet* data, vtkDataArray* values, const Point& lift,
                                             double pixelRatio);
}  // namespace studio

#endif
