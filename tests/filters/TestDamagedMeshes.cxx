// SPDX-License-Identifier: BSD-3-Clause
// Damaged meshes through repair, the search for edges and remeshing, without Python, so that sanitizers see all of it:
// whatever comes in, the areas add up, materials survive, and an error leaves nothing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkKalosSingularEdges.h"
#include "vtkKalosSurfaceRemesh.h"
#include "vtkKalosSurfaceRepair.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTriangle.h"

namespace
{
/// A soup of cells with a material number each.
struct Soup
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Verts, Lines, Polygons, Strips;
  std::vector<int> OfVerts, OfLines, OfPolygons, OfStrips;

  Soup() { this->Points->SetDataTypeToDouble(); }

  vtkIdType Point(double x, double y, double z) { return this->Points->InsertNextPoint(x, y, z); }

  void Polygon(std::initializer_list<vtkIdType> corners, int material)
  {
    this->Polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.begin());
    this->OfPolygons.push_back(material);
  }

  /// Six squares of n x n quads, each with corners of its own; materials first, first + 1, ...
  void Box(const std::array<double, 3>& low, double size, int n, int first)
  {
    for (int side = 0; side < 6; ++side)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
        {
          std::array<vtkIdType, 4> ids{};
          for (int k = 0; k < 4; ++k)
          {
            double p[3];
            const int axis = side % 3;
            p[axis] = side / 3;
            p[(axis + 1) % 3] = (i + (k == 1 || k == 2)) / static_cast<double>(n);
            p[(axis + 2) % 3] = (j + (k > 1)) / static_cast<double>(n);
            ids[k] = this->Point(low[0] + size * p[0], low[1] + size * p[1], low[2] + size * p[2]);
          }
          this->Polygon({ids[0], ids[1], ids[2], ids[3]}, first + side);
        }
  }

  void Fill(vtkPolyData* mesh) const
  {
    mesh->SetPoints(this->Points);
    mesh->SetVerts(this->Verts);
    mesh->SetLines(this->Lines);
    mesh->SetPolys(this->Polygons);
    mesh->SetStrips(this->Strips);
    vtkNew<vtkIntArray> materials;
    materials->SetName("Material");
    for (const auto* part : {&this->OfVerts, &this->OfLines, &this->OfPolygons, &this->OfStrips})
      for (const int material : *part)
        materials->InsertNextValue(material);
    mesh->GetCellData()->AddArray(materials);
  }
};

std::map<std::string, double> ReportOf(vtkTable* table)
{
  std::map<std::string, double> values;
  auto* names = vtkStringArray::SafeDownCast(table->GetColumnByName("Quantity"));
  auto* numbers = vtkDoubleArray::SafeDownCast(table->GetColumnByName("Value"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    values[names->GetValue(i)] = numbers->GetValue(i);
  return values;
}

std::map<int, double> AreasByMaterial(vtkPolyData* mesh)
{
  std::map<int, double> areas;
  auto* materials = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("Material"));
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    areas[materials->GetValue(i)] += vtkTriangle::SafeDownCast(mesh->GetCell(i))->ComputeArea();
  return areas;
}

/// Counts error events and keeps them from the console.
struct Errors
{
  vtkNew<vtkCallbackCommand> Command;
  int Count = 0;
  explicit Errors(vtkObject* of)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
        [](vtkObject*, unsigned long, void* data, void*) { ++static_cast<Errors*>(data)->Count; });
    of->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
};

void Damage(Soup& soup, std::mt19937& random)
{
  const auto pick = [&](vtkIdType n) { return std::uniform_int_distribution<vtkIdType>(0, n - 1)(random); };
  const vtkIdType points = soup.Points->GetNumberOfPoints();
  for (int i = 0; i < 6; ++i)  // triangles across everything, crossing it
    soup.Polygon({pick(points), pick(points), pick(points)}, 50 + i);
  const vtkIdType a = pick(points), b = pick(points), c = pick(points);
  soup.Polygon({a, b, a}, 60);
  soup.Polygon({a, b}, 60);
  soup.Polygon({a, b, c}, 61);
  soup.Polygon({c, b, a}, 61);
  soup.Polygon({b, c, a}, 62);
  soup.Polygon({pick(points), pick(points), pick(points), pick(points), pick(points)}, 63);
  for (int i = 0; i < 5; ++i)  // points a little off
  {
    double p[3];
    const vtkIdType id = pick(points);
    soup.Points->GetPoint(id, p);
    soup.Points->SetPoint(id, p[0] + 1e-8, p[1], p[2] - 1e-8);
  }
  const vtkIdType lone[] = {soup.Point(0.5, 0.5, 0.5)}, line[] = {a, b}, strip[] = {a, b, c, pick(points), a};
  soup.Verts->InsertNextCell(1, lone);
  soup.OfVerts.push_back(90);
  soup.Lines->InsertNextCell(2, line);
  soup.OfLines.push_back(91);
  soup.Strips->InsertNextCell(5, strip);
  soup.OfStrips.push_back(64);
}

#ifdef __SANITIZE_ADDRESS__
constexpr double timeLimit = 600;  // s
#else
constexpr double timeLimit = 60;
#endif

/// Two boxes, of which three meshes in four are damaged.
void FillMesh(unsigned seed, vtkPolyData* mesh)
{
  std::mt19937 random(seed);
  Soup soup;
  soup.Box({0, 0, 0}, 2, 1 + static_cast<int>(seed % 3), 1);
  soup.Box({0.3, 0.4, seed % 2 ? 0.0 : -0.2}, 0.7, 1, 11);
  if (seed % 4)
    Damage(soup, random);
  soup.Fill(mesh);
}

/// Whether the mesh could be remeshed; each material then has the area that it had.
bool RemeshKeepsAreas(vtkPolyData* mesh, unsigned seed, const std::map<int, double>& areas)
{
  vtkNew<vtkKalosSurfaceRemesh> remesh;
  remesh->SetInputData(mesh);
  remesh->SetEdgeLength(0.3);
  remesh->SetSmallestEdgeLength(seed % 5 ? 0 : 0.1);
  remesh->SetTimeLimit(timeLimit);
  const Errors ofRemesh(remesh);
  remesh->Update();
  if (ofRemesh.Count > 0)
  {
    EXPECT_EQ(remesh->GetOutput()->GetNumberOfCells(), 0);
    return false;
  }
  const auto after = AreasByMaterial(remesh->GetOutput());
  for (const auto& [material, area] : areas)
    EXPECT_NEAR(after.at(material), area, 1e-4 * (1 + area)) << "material " << material;
  return true;
}
}  // namespace

TEST(DamagedMeshes, NothingIsLostInAnyFilter)
{
  int remeshed = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    vtkNew<vtkPolyData> mesh;
    FillMesh(seed, mesh);

    vtkNew<vtkKalosSurfaceRepair> repair;
    repair->SetInputData(mesh);
    const Errors ofRepair(repair);
    repair->Update();
    ASSERT_EQ(ofRepair.Count, 0);
    const auto report = ReportOf(repair->GetReport());
    EXPECT_NEAR(report.at("area after") + report.at("area of degenerate triangles dropped") +
                    report.at("area of duplicate triangles dropped"),
                report.at("area before"), 1e-5 * report.at("area before"));
    const auto areas = AreasByMaterial(repair->GetOutput());
    for (int side = 0; side < 6; ++side)
    {
      EXPECT_NEAR(areas.at(1 + side), 4, 1e-5);
      EXPECT_NEAR(areas.at(11 + side), 0.49, 1e-5);
    }
    EXPECT_EQ(report.at("vertices and lines left out"), seed % 4 ? 2 : 0);
    EXPECT_EQ(report.at("polygons of fewer than 3 corners left out"), seed % 4 ? 1 : 0);
    auto* named = repair->GetOutput()->GetFieldData()->GetAbstractArray(vtkKalosSurfaceRepair::UnrepairedArrayName());
    EXPECT_EQ(report.at("cells not repaired"), static_cast<double>(named->GetNumberOfTuples()));
    EXPECT_GE(named->GetNumberOfTuples(), seed % 4 ? 1 : 0);  // the same corners, another material

    vtkNew<vtkKalosSingularEdges> edges;
    edges->SetInputData(0, mesh);
    edges->SetInputData(1, mesh);
    const Errors ofEdges(edges);
    edges->Update();
    EXPECT_EQ(ofEdges.Count, 0);
    EXPECT_GT(edges->GetOutput()->GetNumberOfCells(), 4);
    remeshed += RemeshKeepsAreas(repair->GetOutput(), seed, areas);
  }
  EXPECT_EQ(remeshed, 24);
}

TEST(DamagedMeshes, ErrorsLeaveNothing)
{
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for (const double x : bad)
  {
    Soup soup;
    soup.Box({0, 0, 0}, 1, 1, 1);
    soup.Points->SetPoint(3, x, 0, 0);
    vtkNew<vtkPolyData> mesh;
    soup.Fill(mesh);
    vtkNew<vtkKalosSurfaceRepair> repair;
    vtkNew<vtkKalosSurfaceRemesh> remesh;
    vtkNew<vtkKalosSingularEdges> edges;
    for (vtkPolyDataAlgorithm* filter :
         {static_cast<vtkPolyDataAlgorithm*>(repair), static_cast<vtkPolyDataAlgorithm*>(remesh),
          static_cast<vtkPolyDataAlgorithm*>(edges)})
    {
      filter->SetInputDataObject(mesh);
      const Errors errors(filter);
      filter->Update();
      EXPECT_EQ(errors.Count, 1) << filter->GetClassName();
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << filter->GetClassName();
    }
    EXPECT_EQ(mesh->GetNumberOfCells(), 6);
  }
}
