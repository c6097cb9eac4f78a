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
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

struct vtkKalosSceneReader::Internals
{
  std::vector<kalos::scene::Camera> Cameras;

  const kalos::scene::Camera* Find(int index) const
  {
    return index >= 0 && index < static_cast<int>(this->Cameras.size()) ? &this->Cameras[index] : nullptr;
  }
};

namespace
{
using namespace kalos::scene;

struct Scene
{
  vtkSmartPointer<vtkPolyData> Surfaces;
  vtkSmartPointer<vtkPolyData> Luminaires;
  vtkSmartPointer<vtkMultiBlockDataSet> Receivers;
  std::vector<Camera> Cameras;
};

std::string ReadText(const std::string& path)
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

/** The scene file's text, or for a model the scene that holds nothing but it. */
nlohmann::json ReadJson(const std::string& path)
{
  if (!IsModelFile(path))
  {
    return ParseJson(ReadText(path));
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw InputError("file", "no such file; expected a scene or model file");
  }
  return {{"kalos", 1}, {"surfaces", {{{"file", std::filesystem::path(path).filename().string()}}}}};
}

Scene ReadScene(const std::string& path)
{
  const nlohmann::json json = ReadJson(path);
  const JsonCursor root(json, "scene");
  root.CheckKeys({"kalos", "materials", "surfaces", "luminaires", "receivers", "cameras"});
  root.At("kalos").Integer(1, 1);

  const std::string folder = std::filesystem::path(path).parent_path().string();
  SceneSurfaces surfaces = ReadSurfaces(root, ReadMaterials(root), folder);
  std::set<std::string> names;
  Scene scene;
  scene.Surfaces = MakeSurfaceData(surfaces.All);
  scene.Receivers = ReadReceivers(root, surfaces.All, folder, names, surfaces.Approximations);
  scene.Cameras = ReadCameras(root, names);
  AddModelCameras(surfaces.Cameras, names, scene.Cameras);
  if (surfaces.HasModel && !root.Has("receivers"))
  {
    AddUsualReceivers(surfaces, names, scene.Receivers);
  }
  scene.Luminaires =
      ReadLuminaires(root, folder, surfaces.Lights, LitBall(scene.Surfaces, scene.Receivers), surfaces.Approximations);
  AddLightNotes(surfaces.Lights, surfaces.Approximations);
  PutNotes(surfaces.Approximations, scene.Surfaces);

  if (surfaces.All.empty() && scene.Luminaires->GetNumberOfPoints() == 0)
  {
    root.Fail("empty: no surfaces and no luminaires; expected at least one of them");
  }
  if (scene.Receivers->GetNumberOfBlocks() == 0 && scene.Cameras.empty())
  {
    root.Fail("nothing to compute: no receivers and no cameras; expected at least one of them");
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
  this->Internal->Cameras.clear();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("scene: FileName: not set; expected the path of a scene file");
    return 0;
  }
  try
  {
    Scene scene = ReadScene(this->FileName);
    vtkPolyData::GetData(outputVector, 0)->ShallowCopy(scene.Surfaces);
    vtkPolyData::GetData(outputVector, 1)->ShallowCopy(scene.Luminaires);
    vtkMultiBlockDataSet::GetData(outputVector, 2)->ShallowCopy(scene.Receivers);
    this->Internal->Cameras = std::move(scene.Cameras);
  }
  catch (const InputError& error)
  {
    vtkErrorMacro(<< error.Message(this->FileName));
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< this->FileName << ": scene: needs more memory than there is; expected a smaller scene");
    return 0;
  }
  return 1;
}

int vtkKalosSceneReader::CanReadFile(const char* path)
{
  std::error_code error;
  if (path && IsModelFile(path))
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
  return static_cast<int>(this->Internal->Cameras.size());
}

std::string vtkKalosSceneReader::GetCameraName(int index) const
{
  const Camera* camera = this->Internal->Find(index);
  return camera ? camera->Name : std::string();
}

void vtkKalosSceneReader::GetCameraPosition(int index, double position[3]) const
{
  if (const Camera* camera = this->Internal->Find(index))
  {
    std::copy(camera->Position.begin(), camera->Position.end(), position);
  }
}

void vtkKalosSceneReader::GetCameraTarget(int index, double target[3]) const
{
  if (const Camera* camera = this->Internal->Find(index))
  {
    std::copy(camera->Target.begin(), camera->Target.end(), target);
  }
}

void vtkKalosSceneReader::GetCameraUp(int index, double up[3]) const
{
  if (const Camera* camera = this->Internal->Find(index))
  {
    std::copy(camera->Up.begin(), camera->Up.end(), up);
  }
}

double vtkKalosSceneReader::GetCameraFieldOfView(int index) const
{
  const Camera* camera = this->Internal->Find(index);
  return camera ? camera->FieldOfView : 0.0;
}

void vtkKalosSceneReader::GetCameraResolution(int index, int resolution[2]) const
{
  if (const Camera* camera = this->Internal->Find(index))
  {
    std::copy(camera->Resolution.begin(), camera->Resolution.end(), resolution);
  }
}

void vtkKalosSceneReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfCameras: " << this->GetNumberOfCameras() << "\n";
}
