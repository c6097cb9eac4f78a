// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSurfaceRepair.h"

#include <cmath>
#include <string>

#include "MeshConversion.h"
#include "ReportTable.h"
#include "repair/SurfaceRepair.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace
{
/** By cell: whether it emits. */
std::vector<std::uint8_t> emittingCells(vtkPolyData* input)
{
  std::vector<std::uint8_t> emits;
  if (vtkDataArray* exitance = input->GetCellData()->GetArray(vtkKalosArrayNames::Exitance))
  {
    emits.assign(static_cast<std::size_t>(exitance->GetNumberOfTuples()), 0);
    for (vtkIdType i = 0; i < exitance->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < exitance->GetNumberOfComponents(); ++c)
      {
        emits[i] |= exitance->GetComponent(i, c) > 0.0;
      }
    }
  }
  return emits;
}

void fillReport(const kalos::ConvertedMesh& input, const kalos::meshing::RepairReport& done, vtkTable* table)
{
  kalos::ReportTable report(table);
  const auto count = [&](const char* name, std::size_t value) { report.add(name, "", static_cast<double>(value)); };
  count("polygons", static_cast<std::size_t>(input.polygons));
  count("vertices and lines left out", static_cast<std::size_t>(input.ignored));
  count("polygons of fewer than 3 corners left out", static_cast<std::size_t>(input.degenerate));
  count("points before", done.pointsBefore);
  count("points after", done.pointsAfter);
  count("points merged", done.pointsMerged);
  count("points moved by merging", done.pointsMoved);
  count("unused points dropped", done.pointsUnused);
  count("points added at non-manifold edges and vertices", done.pointsSplit);
  count("triangles before", done.trianglesBefore);
  count("triangles after", done.trianglesAfter);
  count("degenerate triangles dropped", done.degenerate);
  count("duplicate triangles dropped", done.duplicate);
  count("triangles cut to stitch", done.splitTriangles);
  count("triangles turned", done.turned);
  count("border edges before", done.borderBefore);
  count("border edges after", done.borderAfter);
  count("non-manifold edges before", done.nonManifoldBefore);
  count("non-manifold edges after", done.nonManifoldAfter);
  count("surfaces", done.surfaces);
  count("cells not repaired", done.unrepaired.size());
  report.add("tolerance", "m", done.tolerance);
  report.add("area before", "m\xC2\xB2", done.areaBefore);
  report.add("area of degenerate triangles dropped", "m\xC2\xB2", done.degenerateArea);
  report.add("area of duplicate triangles dropped", "m\xC2\xB2", done.duplicateArea);
  report.add("area after", "m\xC2\xB2", done.areaAfter);
  for (int i = 0; i < 3; ++i)
  {
    const std::string axis(1, "xyz"[i]);
    report.add("smallest " + axis + " before", "m", done.boundsBefore.low[i]);
    report.add("largest " + axis + " before", "m", done.boundsBefore.high[i]);
    report.add("smallest " + axis + " after", "m", done.boundsAfter.low[i]);
    report.add("largest " + axis + " after", "m", done.boundsAfter.high[i]);
  }
}

void nameUnrepaired(const std::vector<kalos::meshing::Unrepaired>& unrepaired, vtkPolyData* output)
{
  vtkNew<vtkStringArray> names;
  names->SetName(vtkKalosSurfaceRepair::UnrepairedArrayName());
  names->SetNumberOfComponents(2);
  for (const auto& entry : unrepaired)
  {
    names->InsertNextValue(std::to_string(entry.origin));
    names->InsertNextValue(entry.reason);
  }
  output->GetFieldData()->AddArray(names);
}
}  // namespace

vtkStandardNewMacro(vtkKalosSurfaceRepair);

void vtkKalosSurfaceRepair::Work(vtkPolyData* input, kalos::ConvertedMesh& converted, vtkPolyData* output,
                                 vtkTable* table)
{
  if (!(this->Tolerance >= 0.0 && std::isfinite(this->Tolerance)))
  {
    throw std::invalid_argument("Tolerance is not allowed; expected metres above 0, or 0 for automatic");
  }
  kalos::meshing::RepairSettings settings;
  settings.tolerance = this->Tolerance;
  settings.sided = emittingCells(input);
  settings.keepSides = this->KeepSides;
  auto done = kalos::meshing::repair(converted.mesh, settings, kalos::progressOf(this, this->TimeLimit));
  for (const vtkIdType cell : converted.crossing)
  {
    done.unrepaired.push_back({static_cast<std::uint32_t>(cell), "its outline crosses itself; cut into a fan"});
  }
  kalos::fillPolyData(converted.mesh, input, output);
  nameUnrepaired(done.unrepaired, output);
  fillReport(converted, done, table);
}

void vtkKalosSurfaceRepair::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "KeepSides: " << (this->KeepSides ? "on" : "off") << "\n";
}
