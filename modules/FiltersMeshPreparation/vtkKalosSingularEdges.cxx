// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSingularEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "MeshConversion.h"
#include "ReceiverDistances.h"
#include "ReportTable.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

namespace
{
void fillCurves(const kalos::meshing::Curves& curves, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : curves.points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkIntArray> kind;
  kind->SetName(vtkKalosSingularEdges::EdgeClassArrayName());
  vtkNew<vtkDoubleArray> front, back, severity;
  front->SetName(vtkKalosSingularEdges::DihedralAngleArrayName());
  back->SetName(vtkKalosSingularEdges::DihedralAngleBackArrayName());
  severity->SetName(vtkKalosSingularEdges::SeverityArrayName());
  vtkNew<vtkCellArray> lines;
  for (const auto& curve : curves.curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.count));
    for (std::size_t i = curve.first; i < curve.first + curve.count; ++i)
    {
      lines->InsertCellPoint(curves.indices[i]);
    }
    kind->InsertNextValue(static_cast<int>(curve.edge.kind));
    front->InsertNextValue(kalos::toDegrees(curve.edge.front));
    back->InsertNextValue(kalos::toDegrees(curve.edge.back));
    severity->InsertNextValue(curve.edge.severity);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(kind), static_cast<vtkDataArray*>(front),
                              static_cast<vtkDataArray*>(back), static_cast<vtkDataArray*>(severity)})
  {
    output->GetCellData()->AddArray(array);
  }
  output->GetCellData()->SetActiveScalars(vtkKalosSingularEdges::SeverityArrayName());
}

void fillReport(const kalos::ConvertedMesh& input, const kalos::meshing::EdgeReport& counts, vtkTable* table)
{
  kalos::ReportTable report(table);
  const char* names[] = {"concave edges", "convex edges",       "coplanar edges",
                         "border edges",  "non-manifold edges", "contact pieces"};
  for (int i = 0; i < kalos::meshing::numberOfEdgeClasses; ++i)
  {
    report.add(names[i], "", static_cast<double>(counts.edges[i]));
  }
  report.add("edges whose triangles face opposite ways", "", static_cast<double>(counts.inconsistent));
  report.add("degenerate triangles left out", "", static_cast<double>(counts.degenerate));
  report.add("coincident triangles left out", "", static_cast<double>(counts.duplicate));
  report.add("vertices and lines ignored", "", static_cast<double>(input.ignored));
  report.add("tolerance", "m", counts.tolerance);
}
}  // namespace

vtkStandardNewMacro(vtkKalosSingularEdges);

vtkKalosSingularEdges::vtkKalosSingularEdges()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

const char* vtkKalosSingularEdges::EdgeDistanceArrayName()
{
  return vtkKalosArrayNames::EdgeDistance;
}

const char* vtkKalosSingularEdges::EdgeAngleArrayName()
{
  return vtkKalosArrayNames::EdgeAngle;
}

vtkTable* vtkKalosSingularEdges::GetReport()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkKalosSingularEdges::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    return 1;
  }
  // The composite type comes first: all blocks are taken together, not one by one.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkKalosSingularEdges::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = {"vtkPolyData", "vtkDataObject", "vtkTable"};
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

vtkTypeBool vtkKalosSingularEdges::ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                                                  vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(inputs, outputs);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkKalosSingularEdges::RequestDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* receivers = vtkDataObject::GetData(inputs[1]);
  vtkSmartPointer<vtkDataObject> wanted[] = {vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New(),
                                             vtkSmartPointer<vtkTable>::New()};
  if (receivers)
  {
    wanted[1] = vtk::TakeSmartPointer(receivers->NewInstance());
  }
  for (int port = 0; port < 3; ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    vtkDataObject* there = vtkDataObject::GetData(info);
    if (!there || !there->IsA(wanted[port]->GetClassName()))
    {
      info->Set(vtkDataObject::DATA_OBJECT(), wanted[port]);
    }
  }
  return 1;
}

int vtkKalosSingularEdges::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curvesOutput = vtkPolyData::GetData(outputs, 0);
  vtkDataObject* receiversOutput = vtkDataObject::GetData(outputs, 1);
  vtkTable* table = vtkTable::GetData(outputs, 2);
  return kalos::guarded(this, {curvesOutput, receiversOutput, table}, [&] {
    if (!(this->FlatAngle > 0.0 && this->FlatAngle <= 45.0))
    {
      throw std::invalid_argument("FlatAngle is not allowed; expected degrees above 0, at most 45");
    }
    if (!(this->Tolerance >= 0.0 && std::isfinite(this->Tolerance)))
    {
      throw std::invalid_argument("Tolerance is not allowed; expected metres above 0, or 0 for automatic");
    }
    kalos::checkTimeLimit(this->TimeLimit);
    const kalos::ConvertedMesh input = kalos::convertMesh(vtkPolyData::GetData(inputs[0]));
    kalos::meshing::EdgeSettings settings;
    settings.tolerance = this->Tolerance;
    settings.flat = vtkMath::RadiansFromDegrees(this->FlatAngle);
    settings.bothSides = this->BothSides;
    settings.wanted = {this->ConcaveEdges, this->ConvexEdges,      this->CoplanarEdges,
                       this->BorderEdges,  this->NonManifoldEdges, this->ContactEdges};
    const kalos::meshing::Curves curves =
        kalos::meshing::findSingularEdges(input.mesh, settings, kalos::progressOf(this, this->TimeLimit));
    if (vtkDataObject* receivers = vtkDataObject::GetData(inputs[1]))
    {
      kalos::copyReceivers(receivers, receiversOutput);
      kalos::attachAllDistances(curves, this->BothSides, receiversOutput);
    }
    fillCurves(curves, curvesOutput);
    fillReport(input, curves.report, table);
  });
}

void vtkKalosSingularEdges::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ConcaveEdges: " << this->ConcaveEdges << "\n";
  os << indent << "ConvexEdges: " << this->ConvexEdges << "\n";
  os << indent << "CoplanarEdges: " << this->CoplanarEdges << "\n";
  os << indent << "BorderEdges: " << this->BorderEdges << "\n";
  os << indent << "NonManifoldEdges: " << this->NonManifoldEdges << "\n";
  os << indent << "ContactEdges: " << this->ContactEdges << "\n";
  os << indent << "FlatAngle: " << this->FlatAngle << "\n";
  os << indent << "BothSides: " << this->BothSides << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
}
