// SPDX-License-Identifier: BSD-3-Clause
#include "view/EdgeLines.h"

#include <cmath>

#include "base/Point.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkKalosSingularEdges.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace studio
{
namespace
{
class Collector
{
public:
  Collector()
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    this->Lines->SetPoints(points);
    this->Lines->SetLines(lines);
    this->Severity->SetName(vtkKalosSingularEdges::SeverityArrayName());
    this->Lines->GetCellData()->AddArray(this->Severity);
  }

  void add(const Point& from, const Point& to, double severity)
  {
    this->Lines->GetLines()->InsertNextCell(2);
    for (const Point& p : {from, to})
      this->Lines->GetLines()->InsertCellPoint(this->Lines->GetPoints()->InsertNextPoint(p.GetData()));
    this->Severity->InsertNextValue(severity);
  }

  void addDashes(const Point& from, const Point& to, double severity, double dash)
  {
    const double length = (to - from).Norm();
    const int count = std::max(1, static_cast<int>(std::lround(length / (2 * dash))));
    auto at = [&](double t) { return (1 - t) * from + t * to; };
    for (int k = 0; k < count; ++k)
    {
      const Point begin = at((k + 0.2) / count), end = at((k + 0.8) / count);
      this->add(begin, end, severity);
    }
  }

  vtkSmartPointer<vtkPolyData> lines() const { return this->Lines.Get(); }

private:
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkDoubleArray> Severity;
};
}  // namespace

EdgeLines edgeLines(vtkPolyData* singularEdges, double dash)
{
  Collector edges, contacts;
  vtkDataArray* severities = singularEdges->GetCellData()->GetArray(vtkKalosSingularEdges::SeverityArrayName());
  vtkDataArray* classes = singularEdges->GetCellData()->GetArray(vtkKalosSingularEdges::EdgeClassArrayName());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; severities && classes && i < singularEdges->GetNumberOfCells(); ++i)
  {
    const double severity = severities->GetComponent(i, 0);
    if (!(severity > 0))
      continue;
    singularEdges->GetCellPoints(i, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      Point from, to;
      singularEdges->GetPoint(ids->GetId(k), from.GetData());
      singularEdges->GetPoint(ids->GetId(k + 1), to.GetData());
      if (classes->GetComponent(i, 0) == vtkKalosSingularEdges::CONTACT)
        contacts.addDashes(from, to, severity, dash);
      else
        edges.add(from, to, severity);
    }
  }
  return {edges.lines(), contacts.lines()};
}
}  // namespace studio
