// SPDX-License-Identifier: BSD-3-Clause
#include "ModelScene.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/Names.h"
#include "SceneReceivers.h"
#include "SurfaceReceivers.h"
#include "WorkPlane.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosCalculationPlane.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace kalos::scene
{
namespace
{
constexpr double ShareOfModel = 0.05;  ///< edge length of receivers on surfaces over the size of the model

vtkBoundingBox boundsOf(const std::vector<Surface>& surfaces)
{
  vtkBoundingBox box;
  for (const Surface& surface : surfaces)
  {
    for (const Vector3& point : surface.polygons.points)
    {
      box.AddPoint(point[0], point[1], point[2]);
    }
  }
  return box;
}

/** The plane as cells, none if its grid would be too fine. */
vtkSmartPointer<vtkPolyData> makePlane(const WorkPlane& where)
{
  const double u = where.high[0] - where.low[0], v = where.high[1] - where.low[1];
  const auto cells = standardGrid(u, v);
  if (!cells)
  {
    return nullptr;
  }
  vtkNew<vtkKalosCalculationPlane> plane;
  plane->SetOrigin(where.low[0], where.low[1], where.height);
  plane->SetU(u, 0.0, 0.0);
  plane->SetV(0.0, v, 0.0);
  plane->SetResolution((*cells)[0], (*cells)[1]);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> makeAllSurfaces(const std::vector<Surface>& surfaces, double edgeLength)
{
  Mesh all;
  for (const Surface& surface : surfaces)
  {
    const auto first = static_cast<std::int64_t>(all.points.size());
    const Mesh& mesh = surface.polygons;
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
    {
      std::vector<std::int64_t> corners;
      for (std::int64_t i = mesh.begin(p); i < mesh.ends[p]; ++i)
      {
        corners.push_back(first + mesh.corners[i]);
      }
      all.addPolygon(corners, 0);
    }
  }
  try
  {
    return makeSurfaceReceivers(all, edgeLength, false, MaximumReceivers);
  }
  catch (const std::length_error&)
  {
    throw InputError("receivers",
                     "the file gives none, and its surfaces are too many triangles to compute on; expected a "
                     "scene file around it with receivers");
  }
}

std::string metres(double length)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::round(1000.0 * length) / 1000.0 << " m";
  return text.str();
}
}  // namespace

void addModelCameras(const std::vector<Camera>& found, std::set<std::string>& names, std::vector<Camera>& cameras)
{
  const std::vector<Camera> own = cameras;
  for (Camera camera : found)
  {
    const bool overridden = std::any_of(own.begin(), own.end(), [&](const Camera& c) { return c.name == camera.name; });
    if (!overridden)
    {
      camera.name = freeName(camera.name, "camera", names);
      cameras.push_back(camera);
    }
  }
}

void addUsualReceivers(SceneSurfaces& surfaces, std::set<std::string>& names, vtkMultiBlockDataSet* receivers)
{
  const vtkBoundingBox box = boundsOf(surfaces.all);
  if (!box.IsValid())
  {
    return;
  }
  double top = box.GetMaxPoint()[2];
  for (const ModelLight& light : surfaces.lights)
  {
    top = light.type == ModelLight::Kind::Parallel ? top : std::max(top, light.position[2]);
  }
  vtkSmartPointer<vtkPolyData> data;
  std::string name = "workplane";
  if (const auto plane = findWorkPlane(surfaces.all, top))
  {
    data = makePlane(*plane);
    surfaces.approximations.push_back({"receivers", "workplane at z = " + metres(plane->height),
                                       "the file gives none: 0.75 m above the floor at " + metres(plane->floor) +
                                           ", over its extent, on the grid of EN 12464-1"});
  }
  if (!data)
  {
    name = "surfaces";
    const double edge = ShareOfModel * box.GetMaxLength();
    data = makeAllSurfaces(surfaces.all, edge);
    surfaces.approximations.push_back({"receivers", "all surfaces, in triangles of at most " + metres(edge),
                                       "the file gives none, and no plane 0.75 m above a floor fits into the model"});
  }
  const unsigned int block = receivers->GetNumberOfBlocks();
  receivers->SetBlock(block, data);
  receivers->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), freeName(name, "", names).c_str());
}

Ball litBall(vtkPolyData* surfaces, vtkMultiBlockDataSet* receivers)
{
  vtkBoundingBox box;
  if (surfaces->GetNumberOfPoints() > 0)
  {
    box.AddBounds(surfaces->GetBounds());
  }
  for (unsigned int i = 0; i < receivers->GetNumberOfBlocks(); ++i)
  {
    const auto* block = vtkDataSet::SafeDownCast(receivers->GetBlock(i));
    if (block && const_cast<vtkDataSet*>(block)->GetNumberOfPoints() > 0)
    {
      box.AddBounds(const_cast<vtkDataSet*>(block)->GetBounds());
    }
  }
  Ball ball;
  ball.radius = 1.0;
  if (box.IsValid())
  {
    box.GetCenter(ball.center.data());
    const double diagonal = box.GetDiagonalLength();
    ball.radius = diagonal > 0.0 ? 0.5 * diagonal : 1.0;
  }
  return ball;
}

void addLightNotes(const std::vector<ModelLight>& lights, Notes& notes)
{
  int spots = 0, parallel = 0;
  for (const ModelLight& light : lights)
  {
    spots += light.type == ModelLight::Kind::Spot;
    parallel += light.type == ModelLight::Kind::Parallel;
  }
  if (spots > 0)
  {
    notes.push_back({"spot lights", std::to_string(spots) + ", by a candela table of 128 steps",
                     "intensity between the cones as KHR_lights_punctual gives it, within 1e-4 of the middle's"});
  }
  if (parallel > 0)
  {
    notes.push_back({"directional lights", std::to_string(parallel) + ", as far points",
                     "from 1000 radii of the scene away, its illuminance within 0.2 % of the file's"});
  }
}

void putNotes(const Notes& notes, vtkPolyData* surfaces)
{
  vtkNew<vtkStringArray> table;
  table->SetName(vtkKalosArrayNames::SceneNotes);
  table->SetNumberOfComponents(3);
  for (const Note& note : joinFilesElsewhere(notes))
  {
    for (const std::string& text : {note.subject, note.choice, note.reason})
    {
      table->InsertNextValue(text);
    }
  }
  surfaces->GetFieldData()->AddArray(table);
}
}  // namespace kalos::scene
