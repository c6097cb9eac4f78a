// SPDX-License-Identifier: BSD-3-Clause
#include "view/ValueLabels.h"

#include <cmath>
#include <map>

#include "base/DataSets.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"
#include "vtkTextProperty.h"

namespace studio
{
namespace
{
constexpr int mostLabels = 144;  // of a plane

vtkSmartPointer<vtkProp> label(const Point& place, double value, double pixelRatio)
{
  auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  actor->SetInput(shortNumber(value).toUtf8().constData());
  actor->SetPosition(place[0], place[1], place[2]);
  vtkTextProperty* text = actor->GetTextProperty();
  text->SetFontSize(static_cast<int>(std::lround(11 * pixelRatio)));
  text->SetColor(1, 1, 1);
  text->SetShadow(true);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  actor->PickableOff();
  return actor;
}

/// Every how many points of a row or column a label stands, for a square of so many points.
vtkIdType strideOf(vtkIdType points)
{
  return std::max<vtkIdType>(1, static_cast<vtkIdType>(std::ceil(std::sqrt(static_cast<double>(points) / mostLabels))));
}

/// The length of a row: how many centres follow each other in one direction.
vtkIdType rowOf(vtkDataSet* data)
{
  const vtkIdType cells = data->GetNumberOfCells();
  if (cells < 3)
    return cells;
  const Point first = cellCentre(data, 0), step = cellCentre(data, 1) - first;
  for (vtkIdType i = 2; i < cells; ++i)
    if ((cellCentre(data, i) - first - static_cast<double>(i) * step).Norm() > 0.01 * step.Norm())
      return i;
  return cells;
}
}  // namespace

QString shortNumber(double value)
{
  const double size = std::abs(value);
  return QString::number(value, 'f', size >= 100 || size == 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

QVector<vtkSmartPointer<vtkProp>> contourLabels(vtkPolyData* contours, const char* array, const Point& lift,
                                                double pixelRatio)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(contours);
  stripper->JoinContiguousSegmentsOn();
  stripper->Update();
  vtkPolyData* lines = stripper->GetOutput();
  vtkDataArray* values = lines->GetPointData()->GetArray(array);
  std::map<double, vtkIdType> longest;  // by value: the line with the most points
  for (vtkIdType i = 0; values && i < lines->GetNumberOfCells(); ++i)
  {
    const vtkIdType size = lines->GetCellSize(i);
    vtkIdType points;
    const vtkIdType* ids;
    lines->GetCellPoints(i, points, ids);
    const auto found = longest.emplace(values->GetComponent(ids[0], 0), i);
    if (!found.second && size > lines->GetCellSize(found.first->second))
      found.first->second = i;
  }
  QVector<vtkSmartPointer<vtkProp>> labels;
  for (const auto& [value, line] : longest)
  {
    vtkIdType points;
    const vtkIdType* ids;
    lines->GetCellPoints(line, points, ids);
    labels << label(Point(lines->GetPoint(ids[points / 2])) + lift, value, pixelRatio);
  }
  return labels;
}

QVector<vtkSmartPointer<vtkProp>> cellLabels(vtkDataSet* data, vtkDataArray* values, const Point& lift,
                                             double pixelRatio)
{
  const vtkIdType row = rowOf(data), stride = strideOf(data->GetNumberOfCells());
  QVector<vtkSmartPointer<vtkProp>> labels;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    if ((i / row) % stride == stride / 2 && (i % row) % stride == stride / 2)
      labels << label(cellCentre(data, i) + lift, values->GetComponent(i, 0), pixelRatio);
  return labels;
}
}  // namespace studio
