// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSceneReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <set>
#include <vector>

#include "base/InputError.h"
#include "model/ModelFile.h"
#include "scene/ModelScene.h"
#include "scene/SceneCameras.h"
#include "scene/SceneLuminaires.h"
#include "scene/SceneMaterials.h"
#include "scene/SceneReceivers.h"
#include "scene/SceneSurfaces.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

struct vtkKalosSceneReader::Internals
{
  std::vector<kalos::scene::Camera> cameras;

  const kalos::scene::Camera* find(int index) const
  {
    return index >= 0 && index < static_cast<int>(this->cameras.size()) ? &this->cameras[index] : nullptr;
  }
};

namespace
{
using namespace kalos::scene;

struct Scene
{
  vtkSmartPointer<vtkPolyData> surfaces;
  vtkSmartPointer<vtkPolyData> luminaires;
  vtkSmartPointer<vtkMultiBlockDataSet> receivers;
  std::vector<Camera> cameras;
};

std::string readText(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw InputError("file", "no such file; expected a scene file");
  }
  if (std::filesystem::file_size(path, error) > MaximumBytes)
  {
    throw InputError("file", "larger than " + std::to_string(MaximumBytes >> 20) + " MiB; expected a scene file");
  }
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file)
  {
    throw InputError("file", "cannot be read; expected a readable scene file");
  }
  return text;
}

/** The scene file's text, or for a model a scene with only the model. */
nlohmann::json readJson(const std::string& path, double unit, const std::string& up)
{
  if (!isModelFile(path))
  {
    return parseJson(readText(path));
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw InputError("file", "no such file; expected a scene or model file");
  }
  nlohmann::json model{{"file", std::filesystem::path(path).filename().string()}};
  if (unit != 1.0)
  {
    model["scale"] = unit;
  }
  if (!up.empty())
  {
    model["up"] = up;
  }
  return {{"kalos", 1}, {"surfaces", nlohmann::json::array({model})}};
}

/** Without light every value is 0; say so, because the results alone look like an estimate. */
void tellDarkness(const Scene& scene, Notes& notes)
{
  vtkDataArray* flux = scene.luminaires->GetPointData()->GetArray(vtkKalosArrayNames::LuminousFlux);
  vtkDataArray* exitance = scene.surfaces->GetCellData()->GetArray(vtkKalosArrayNames::Exitance);
  const auto shines = [](vtkDataArray* array) {
    for (int c = 0; array && array->GetNumberOfTuples() > 0 && c < array->GetNumberOfComponents(); ++c)
    {
      if (array->GetRange(c)[1] > 0.0)
      {
        return true;
      }
    }
    return false;
  };
  if (!shines(flux) && !shines(exitance))
  {
    notes.push_back(
        {"warning", "nothing emits light", "no luminaire has a flux and no surface an exitance: every value is 0"});
  }
}

Scene readScene(const std::string& path, double unit, const std::string& up)
{
  const nlohmann::json json = readJson(path, unit, up);
  const JsonCursor root(json, "scene");
  root.checkKeys({"kalos", "materials", "surfaces", "luminaires", "receivers", "cameras", "$schema"});
  root.at("kalos").integer(1, 1);

  const std::string folder = std::filesystem::path(path).parent_path().string();
  SceneSurfaces surfaces = readSurfaces(root, readMaterials(root), folder);
  std::set<std::string> names;
  Scene scene;
  scene.surfaces = makeSurfaceData(surfaces.all);
  scene.receivers = readReceivers(root, surfaces.all, folder, names, surfaces.approximations);
  scene.cameras = readCameras(root, names);
  addModelCameras(surfaces.cameras, names, scene.cameras);
  if (surfaces.hasModel && !root.has("receivers"))
  {
    addUsualReceivers(surfaces, names, scene.receivers);
  }
  scene.luminaires =
      readLuminaires(root, folder, surfaces.lights, litBall(scene.surfaces, scene.receivers), surfaces.approximations);
  addLightNotes(surfaces.lights, surfaces.approximations);
  tellDarkness(scene, surfaces.approximations);
  putNotes(surfaces.approximations, scene.surfaces);

  if (surfaces.all.empty() && scene.luminaires->GetNumberOfPoints() == 0)
  {
    root.fail("empty: no surfaces and no luminaires; expected at least one of them");
  }
  if (scene.receivers->GetNumberOfBlocks() == 0 && scene.cameras.empty())
  {
    root.fail("nothing to compute: no receivers and no cameras; expected at least one of them");
  }
  return scene;
}
}  // namespace

vtkStandardNewMacro(vtkKalosSceneReader);

vtkKalosSceneReader::vtkKalosSceneReader() : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

vtkKalosSceneReader::~vtkKalosSceneReader()
{
  this->SetFileName(nullptr);
}

int vtkKalosSceneReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

vtkTypeBool vtkKalosSceneReader::ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
                                                vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->RequestData(outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkKalosSceneReader::RequestData(vtkInformationVector* outputVector)
{
  this->Internal->cameras.clear();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("scene: FileName: not set; expected the path of a scene file");
    return 0;
  }
  try
  {
    Scene scene = readScene(this->FileName, this->ModelUnit, this->ModelUp);
    vtkPolyData::GetData(outputVector, 0)->ShallowCopy(scene.surfaces);
    vtkPolyData::GetData(outputVector, 1)->ShallowCopy(scene.luminaires);
    vtkMultiBlockDataSet::GetData(outputVector, 2)->ShallowCopy(scene.receivers);
    this->Internal->cameras = std::move(scene.cameras);
  }
  catch (const InputError& error)
  {
    vtkErrorMacro(<< error.message(this->FileName));
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< this->FileName << ": scene: does not fit in memory; expected a smaller scene");
    return 0;
  }
  return 1;
}

int vtkKalosSceneReader::CanReadFile(const char* path)
{
  std::error_code error;
  if (path && isModelFile(path))
  {
    return std::filesystem::is_regular_file(path, error);
  }
  std::ifstream file(path ? path : "", std::ios::binary);
  std::string start(4096, '\0');
  file.read(&start[0], static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t brace = start.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return brace != std::string::npos && start[brace] == '{' && start.find("\"kalos\"") != std::string::npos;
}

vtkPolyData* vtkKalosSceneReader::GetSurfaces()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkPolyData* vtkKalosSceneReader::GetLuminaires()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkMultiBlockDataSet* vtkKalosSceneReader::GetReceivers()
{
  return vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkKalosSceneReader::GetNumberOfCameras() const
{
  return static_cast<int>(this->Internal->cameras.size());
}

std::string vtkKalosSceneReader::GetCameraName(int index) const
{
  const Camera* camera = this->Internal->find(index);
  return camera ? camera->name : std::string();
}

void vtkKalosSceneReader::GetCameraPosition(int index, double position[3]) const
{
  if (const Camera* camera = this->Internal->find(index))
  {
    std::copy(camera->position.begin(), camera->position.end(), position);
  }
}

void vtkKalosSceneReader::GetCameraTarget(int index, double target[3]) const
{
  if (const Camera* camera = this->Internal->find(index))
  {
    std::copy(camera->target.begin(), camera->target.end(), target);
  }
}

void vtkKalosSceneReader::GetCameraUp(int index, double up[3]) const
{
  if (const Camera* camera = this->Internal->find(index))
  {
    std::copy(camera->up.begin(), camera->up.end(), up);
  }
}

double vtkKalosSceneReader::GetCameraFieldOfView(int index) const
{
  const Camera* camera = this->Internal->find(index);
  return camera ? camera->fieldOfView : 0.0;
}

void vtkKalosSceneReader::GetCameraResolution(int index, int resolution[2]) const
{
  if (const Camera* camera = this->Internal->find(index))
  {
    std::copy(camera->resolution.begin(), camera->resolution.end(), resolution);
  }
}

void vtkKalosSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ModelUnit: " << this->ModelUnit << " m\n";
  os << indent << "ModelUp: " << this->ModelUp << "\n";
  os << indent << "NumberOfCameras: " << this->GetNumberOfCameras() << "\n";
}
