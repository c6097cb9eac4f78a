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

vtkBoundingBox BoundsOf(const std::vector<Surface>& surfaces)
{
  vtkBoundingBox box;
  for (const Surface& surface : surfaces)
  {
    for (const Vector3& point : surface.Polygons.Points)
    {
      box.AddPoint(point[0], point[1], point[2]);
    }
  }
  return box;
}

/** The plane as cells, none if its grid would be too fine. */
vtkSmartPointer<vtkPolyData> MakePlane(const WorkPlane& where)
{
  const double u = where.High[0] - where.Low[0], v = where.High[1] - where.Low[1];
  const auto cells = StandardGrid(u, v);
  if (!cells)
  {
    return nullptr;
  }
  vtkNew<vtkKalosCalculationPlane> plane;
  plane->SetOrigin(where.Low[0], where.Low[1], where.Height);
  plane->SetU(u, 0.0, 0.0);
  plane->SetV(0.0, v, 0.0);
  plane->SetResolution((*cells)[0], (*cells)[1]);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeAllSurfaces(const std::vector<Surface>& surfaces, double edgeLength)
{
  Mesh all;
  for (const Surface& surface : surfaces)
  {
    const auto first = static_cast<std::int64_t>(all.Points.size());
    const Mesh& mesh = surface.Polygons;
    all.Points.insert(all.Points.end(), mesh.Points.begin(), mesh.Points.end());
    for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
    {
      std::vector<std::int64_t> corners;
      for (std::int64_t i = mesh.Begin(p); i < mesh.Ends[p]; ++i)
      {
        corners.push_back(first + mesh.Corners[i]);
      }
      all.AddPolygon(corners, 0);
    }
  }
  try
  {
    return MakeSurfaceReceivers(all, edgeLength, false, MaximumReceivers);
  }
  catch (const std::length_error&)
  {
    throw InputError("receivers",
                     "the file gives none, and its surfaces are too many triangles to compute on; expected a "
                     "scene file around it with receivers");
  }
}

std::string Metres(double length)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::round(1000.0 * length) / 1000.0 << " m";
  return text.str();
}
}  // namespace

void AddModelCameras(const std::vector<Camera>& found, std::set<std::string>& names, std::vector<Camera>& cameras)
{
  const std::vector<Camera> own = cameras;
  for (Camera camera : found)
  {
    const bool overridden = std::any_of(own.begin(), own.end(), [&](const Camera& c) { return c.Name == camera.Name; });
    if (!overridden)
    {
      camera.Name = FreeName(camera.Name, "camera", names);
      cameras.push_back(camera);
    }
  }
}

void AddUsualReceivers(SceneSurfaces& surfaces, std::set<std::string>& names, vtkMultiBlockDataSet* receivers)
{
  const vtkBoundingBox box = BoundsOf(surfaces.All);
  if (!box.IsValid())
  {
    return;
  }
  double top = box.GetMaxPoint()[2];
  for (const ModelLight& light : surfaces.Lights)
  {
    top = light.Type == ModelLight::Kind::Parallel ? top : std::max(top, light.Position[2]);
  }
  vtkSmartPointer<vtkPolyData> data;
  std::string name = "workplane";
  if (const auto plane = FindWorkPlane(surfaces.All, top))
  {
    data = MakePlane(*plane);
    surfaces.Approximations.push_back({"receivers", "workplane at z = " + Metres(plane->Height),
                                       "the file gives none: 0.75 m above the floor at " + Metres(plane->Floor) +
                                           ", over its extent, on the grid of EN 12464-1"});
  }
  if (!data)
  {
    name = "surfaces";
    const double edge = ShareOfModel * box.GetMaxLength();
    data = MakeAllSurfaces(surfaces.All, edge);
    surfaces.Approximations.push_back({"receivers", "all surfaces, in triangles of at most " + Metres(edge),
                                       "the file gives none, and no plane 0.75 m above a floor fits into the model"});
  }
  const unsigned int block = receivers->GetNumberOfBlocks();
  receivers->SetBlock(block, data);
  receivers->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), FreeName(name, "", names).c_str());
}

Ball LitBall(vtkPolyData* surfaces, vtkMultiBlockDataSet* receivers)
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
  ball.Radius = 1.0;
  if (box.IsValid())
  {
    box.GetCenter(ball.Center.data());
    const double diagonal = box.GetDiagonalLength();
    ball.Radius = diagonal > 0.0 ? 0.5 * diagonal : 1.0;
  }
  return ball;
}

void AddLightNotes(const std::vector<ModelLight>& lights, Notes& notes)
{
  int spots = 0, parallel = 0;
  for (const ModelLight& light : lights)
  {
    spots += light.Type == ModelLight::Kind::Spot;
    parallel += light.Type == ModelLight::Kind::Parallel;
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

void PutNotes(const Notes& notes, vtkPolyData* surfaces)
{
  vtkNew<vtkStringArray> table;
  table->SetName(vtkKalosArrayNames::SceneNotes);
  table->SetNumberOfComponents(3);
  for (const Note& note : JoinFilesElsewhere(notes))
  {
    for (const std::string& text : {note.Subject, note.Choice, note.Reason})
    {
      table->InsertNextValue(text);
    }
  }
  surfaces->GetFieldData()->AddArray(table);
}
}  // namespace kalos::scene
