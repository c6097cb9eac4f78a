// SPDX-License-Identifier: BSD-3-Clause
#include "view/EdgeLines.h"

#include <cmath>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkKalosSingularEdges.h"
#include "vtkMath.h"
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

  void add(const double from[3], const double to[3], double severity)
  {
    this->Lines->GetLines()->InsertNextCell(2);
    for (const double* p : {from, to})
      this->Lines->GetLines()->InsertCellPoint(this->Lines->GetPoints()->InsertNextPoint(p));
    this->Severity->InsertNextValue(severity);
  }

  void addDashes(const double from[3], const double to[3], double severity, double dash)
  {
    const double length = std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    const int count = std::max(1, static_cast<int>(std::lround(length / (2 * dash))));
    auto at = [&](double t, double p[3]) {
      for (int i = 0; i < 3; ++i)
        p[i] = (1 - t) * from[i] + t * to[i];
    };
    for (int k = 0; k < count; ++k)
    {
      double begin[3], end[3];
      at((k + 0.2) / count, begin);
      at((k + 0.8) / count, end);
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
      double from[3], to[3];
      singularEdges->GetPoint(ids->GetId(k), from);
      singularEdges->GetPoint(ids->GetId(k + 1), to);
      if (classes->GetComponent(i, 0) == vtkKalosSingularEdges::CONTACT)
        contacts.addDashes(from, to, severity, dash);
      else
        edges.add(from, to, severity);
    }
  }
  return {edges.lines(), contacts.lines()};
}
}  // namespace studio
