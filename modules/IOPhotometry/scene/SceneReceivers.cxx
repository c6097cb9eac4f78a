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
bool readFlip(const JsonCursor& node)
{
  const auto flip = node.find("flip");
  return flip && flip->boolean();
}

std::array<int, 2> readGrid(const JsonCursor& plane)
{
  const auto spacing = plane.find("spacing");
  if (!spacing)
  {
    return plane.at("resolution").resolution();
  }
  if (plane.has("resolution"))
  {
    spacing->fail("\"resolution\" is given as well; expected one of them");
  }
  if (spacing->string() != "EN 12464-1")
  {
    spacing->failExpected("\"EN 12464-1\"");
  }
  const auto cells = standardGrid(norm(plane.at("u").vector()), norm(plane.at("v").vector()));
  if (!cells)
  {
    plane.fail("too long or too narrow for the grid of EN 12464-1; expected a \"resolution\"");
  }
  return *cells;
}

vtkSmartPointer<vtkPolyData> readPlane(const JsonCursor& receiver, std::int64_t most)
{
  receiver.checkKeys({"name", "plane", "flip", "task"});
  const JsonCursor node = receiver.at("plane");
  node.checkKeys({"origin", "u", "v", "resolution", "spacing", "flip"});
  if (node.has("flip") && receiver.has("flip"))
  {
    receiver.at("flip").fail("\"flip\" is given twice; expected once");
  }
  vtkNew<vtkKalosCalculationPlane> plane;
  plane->SetOrigin(node.at("origin").vector().data());
  plane->SetU(node.at("u").vector().data());
  plane->SetV(node.at("v").vector().data());
  const std::array<int, 2> grid = readGrid(node);
  if (std::int64_t{grid[0]} * grid[1] > most)
  {
    node.failExpected(fewerReceivers(most));
  }
  plane->SetResolution(grid.data());
  plane->SetFlip(readFlip(node) || readFlip(receiver));
  ErrorCatcher errors(plane);
  plane->Update();
  if (!errors.empty())
  {
    node.fail(errors.firstLine());
  }
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> readSurface(const JsonCursor& receiver, const std::vector<Surface>& surfaces,
                                         std::int64_t most)
{
  receiver.checkKeys({"name", "surface", "edge_length", "flip", "task"});
  const JsonCursor node = receiver.at("surface");
  const std::string name = node.string();
  const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& s) { return s.name == name; });
  if (found == surfaces.end())
  {
    node.failExpected("the name of one of \"surfaces\"");
  }
  const JsonCursor length = receiver.at("edge_length");
  try
  {
    return makeSurfaceReceivers(found->polygons, length.numberAbove(0.0), readFlip(receiver), most);
  }
  catch (const std::length_error& error)
  {
    length.failExpected(error.what());
  }
}

/** An observer: a point whose normal is the line of sight. */
vtkSmartPointer<vtkPolyData> readObserver(const JsonCursor& receiver)
{
  receiver.checkKeys({"name", "observer", "task"});
  const JsonCursor node = receiver.at("observer");
  node.checkKeys({"position", "target", "up"});
  const Sight sight = readSight(node);
  auto observer = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType id = points->InsertNextPoint(sight.position.data());
  observer->SetPoints(points);
  observer->AllocateExact(1, 1);
  observer->InsertNextCell(VTK_VERTEX, 1, &id);
  const Vector3 view = sight.target - sight.position;
  const auto vector = [](const char* name, const Vector3& v) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->InsertNextTuple(v.data());
    return array;
  };
  observer->GetPointData()->SetNormals(vector("Normals", 1.0 / norm(view) * view));
  observer->GetPointData()->AddArray(vector(vtkKalosArrayNames::ObserverUp, sight.up));
  return observer;
}

/** Required values, which whoever judges results reads again: an observer's glare, else mean and uniformity. */
void checkTask(const JsonCursor& task, bool ofObserver)
{
  if (ofObserver)
  {
    task.checkKeys({"UGR"});
    task.at("UGR").numberAbove(0.0);
    return;
  }
  task.checkKeys({"mean", "U0"});
  task.at("mean").numberAbove(0.0);
  if (const auto uniformity = task.find("U0"))
  {
    uniformity->share();
  }
}

vtkSmartPointer<vtkPolyData> readReceiver(const JsonCursor& node, const std::vector<Surface>& surfaces,
                                          const std::string& folder, std::int64_t most, Notes& notes)
{
  const int kinds =
      int(node.has("plane")) + int(node.has("points")) + int(node.has("surface")) + int(node.has("observer"));
  if (kinds != 1)
  {
    node.fail(std::to_string(kinds) +
              " kinds of receiver; expected one of \"plane\", \"points\", \"surface\" and \"observer\"");
  }
  if (const auto task = node.find("task"))
  {
    checkTask(*task, node.has("observer"));
  }
  if (node.has("plane"))
  {
    return readPlane(node, most);
  }
  if (node.has("surface"))
  {
    return readSurface(node, surfaces, most);
  }
  if (node.has("observer"))
  {
    return readObserver(node);
  }
  node.checkKeys({"name", "points", "task"});
  const JsonCursor points = node.at("points");
  return readProbeFile(points, resolvePath(folder, points.string(), notes), most);
}
}  // namespace

std::string fewerReceivers(std::int64_t most)
{
  return "at most " + std::to_string(most) + " receivers, as all sets of a scene together may have " +
         std::to_string(MaximumReceivers);
}

std::optional<std::array<int, 2>> standardGrid(double u, double v)
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

vtkSmartPointer<vtkMultiBlockDataSet> readReceivers(const JsonCursor& scene, const std::vector<Surface>& surfaces,
                                                    const std::string& folder, std::set<std::string>& names,
                                                    Notes& notes)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  std::int64_t left = MaximumReceivers;
  const auto section = scene.find("receivers");
  for (const JsonCursor& node : section ? section->items() : std::vector<JsonCursor>())
  {
    const unsigned int block = blocks->GetNumberOfBlocks();
    const auto data = readReceiver(node, surfaces, folder, left, notes);
    left -= data->GetNumberOfCells();  // vertices are cells too
    const std::string name = node.name();
    if (!names.insert(name).second)
    {
      node.fail("another receiver or camera has this name; expected a name of its own, as results are named after it");
    }
    blocks->SetBlock(block, data);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  return blocks;
}
}  // namespace kalos::scene
