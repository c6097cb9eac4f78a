// SPDX-License-Identifier: BSD-3-Clause
#include "SceneReceivers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../base/ErrorCatcher.h"
#include "../base/FilePaths.h"
#include "ProbeFile.h"
#include "SceneCameras.h"
#include "SurfaceReceivers.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosCalculationPlane.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace kalos::scene
{
namespace
{
bool ReadFlip(const JsonCursor& node)
{
  const auto flip = node.Find("flip");
  return flip && flip->Boolean();
}

std::array<int, 2> ReadGrid(const JsonCursor& plane)
{
  const auto spacing = plane.Find("spacing");
  if (!spacing)
  {
    return plane.At("resolution").Resolution();
  }
  if (plane.Has("resolution"))
  {
    spacing->Fail("\"resolution\" is given as well; expected one of them");
  }
  if (spacing->String() != "EN 12464-1")
  {
    spacing->FailExpected("\"EN 12464-1\"");
  }
  const auto cells = StandardGrid(norm(plane.At("u").Vector()), norm(plane.At("v").Vector()));
  if (!cells)
  {
    plane.Fail("too long or too narrow for the grid of EN 12464-1; expected a \"resolution\"");
  }
  return *cells;
}

vtkSmartPointer<vtkPolyData> ReadPlane(const JsonCursor& receiver, std::int64_t most)
{
  receiver.CheckKeys({"name", "plane", "flip"});
  const JsonCursor node = receiver.At("plane");
  node.CheckKeys({"origin", "u", "v", "resolution", "spacing", "flip"});
  if (node.Has("flip") && receiver.Has("flip"))
  {
    receiver.At("flip").Fail("\"flip\" is given twice; expected once");
  }
  vtkNew<vtkKalosCalculationPlane> plane;
  plane->SetOrigin(node.At("origin").Vector().data());
  plane->SetU(node.At("u").Vector().data());
  plane->SetV(node.At("v").Vector().data());
  const std::array<int, 2> grid = ReadGrid(node);
  if (std::int64_t{grid[0]} * grid[1] > most)
  {
    node.FailExpected(FewerReceivers(most));
  }
  plane->SetResolution(grid.data());
  plane->SetFlip(ReadFlip(node) || ReadFlip(receiver));
  ErrorCatcher errors(plane);
  plane->Update();
  if (!errors.Empty())
  {
    node.Fail(errors.FirstLine());
  }
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadSurface(const JsonCursor& receiver, const std::vector<Surface>& surfaces,
                                         std::int64_t most)
{
  receiver.CheckKeys({"name", "surface", "edge_length", "flip"});
  const JsonCursor node = receiver.At("surface");
  const std::string name = node.String();
  const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& s) { return s.Name == name; });
  if (found == surfaces.end())
  {
    node.FailExpected("the name of one of \"surfaces\"");
  }
  const JsonCursor length = receiver.At("edge_length");
  try
  {
    return MakeSurfaceReceivers(found->Polygons, length.NumberAbove(0.0), ReadFlip(receiver), most);
  }
  catch (const std::length_error& error)
  {
    length.FailExpected(error.what());
  }
}

/** One eye: a point whose normal is the line of sight. */
vtkSmartPointer<vtkPolyData> ReadObserver(const JsonCursor& receiver)
{
  receiver.CheckKeys({"name", "observer"});
  const JsonCursor node = receiver.At("observer");
  node.CheckKeys({"position", "target", "up"});
  const Sight sight = ReadSight(node);
  auto observer = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType id = points->InsertNextPoint(sight.Position.data());
  observer->SetPoints(points);
  observer->AllocateExact(1, 1);
  observer->InsertNextCell(VTK_VERTEX, 1, &id);
  const Vector3 view = sight.Target - sight.Position;
  const auto vector = [](const char* name, const Vector3& v) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->InsertNextTuple(v.data());
    return array;
  };
  observer->GetPointData()->SetNormals(vector("Normals", 1.0 / norm(view) * view));
  observer->GetPointData()->AddArray(vector(vtkKalosArrayNames::ObserverUp, sight.Up));
  return observer;
}

vtkSmartPointer<vtkPolyData> ReadReceiver(const JsonCursor& node, const std::vector<Surface>& surfaces,
                                          const std::string& folder, std::int64_t most, Notes& notes)
{
  const int kinds =
      int(node.Has("plane")) + int(node.Has("points")) + int(node.Has("surface")) + int(node.Has("observer"));
  if (kinds != 1)
  {
    node.Fail(std::to_string(kinds) +
              " kinds of receiver; expected one of \"plane\", \"points\", \"surface\" and \"observer\"");
  }
  if (node.Has("plane"))
  {
    return ReadPlane(node, most);
  }
  if (node.Has("surface"))
  {
    return ReadSurface(node, surfaces, most);
  }
  if (node.Has("observer"))
  {
    return ReadObserver(node);
  }
  node.CheckKeys({"name", "points"});
  const JsonCursor points = node.At("points");
  return ReadProbeFile(points, ResolvePath(folder, points.String(), notes), most);
}
}  // namespace

std::string FewerReceivers(std::int64_t most)
{
  return "at most " + std::to_string(most) + " receivers, as all sets of a scene together may have " +
         std::to_string(MaximumReceivers);
}

std::optional<std::array<int, 2>> StandardGrid(double u, double v)
{
  const double longer = std::max(u, v), shorter = std::min(u, v);
  const double spacing = std::min(10.0, 0.2 * std::pow(5.0, std::log10(longer < 2.0 * shorter ? longer : shorter)));
  std::array<int, 2> cells{};
  for (int i = 0; i < 2; ++i)
  {
    const double count = std::max(1.0, std::round((i == 0 ? u : v) / spacing));
    if (!(count < 1e4))
    {
      return {};
    }
    cells[i] = static_cast<int>(count);
  }
  return cells;
}

vtkSmartPointer<vtkMultiBlockDataSet> ReadReceivers(const JsonCursor& scene, const std::vector<Surface>& surfaces,
                                                    const std::string& folder, std::set<std::string>& names,
                                                    Notes& notes)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  std::int64_t left = MaximumReceivers;
  const auto section = scene.Find("receivers");
  for (const JsonCursor& node : section ? section->Items() : std::vector<JsonCursor>())
  {
    const unsigned int block = blocks->GetNumberOfBlocks();
    const auto data = ReadReceiver(node, surfaces, folder, left, notes);
    left -= data->GetNumberOfCells();  // vertices are cells too
    const std::string name = node.Name();
    if (!names.insert(name).second)
    {
      node.Fail("another receiver or camera has this name; expected a name of its own, as results are named after it");
    }
    blocks->SetBlock(block, data);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  return blocks;
}
}  // namespace kalos::scene
