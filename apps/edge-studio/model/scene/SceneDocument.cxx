// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneDocument.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QTemporaryDir>

#include "base/DataSets.h"
#include "base/ErrorCollector.h"
#include "base/Files.h"
#include "base/Problem.h"
#include "scene/BareMesh.h"
#include "scene/Furnace.h"
#include "scene/SceneDraft.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosSceneReader.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
/// Whether a set is a cut of a surface: triangles with cell normals.
bool isSurfaceCut(vtkDataObject* block)
{
  auto* data = vtkPolyData::SafeDownCast(block);
  return data && data->GetCellData()->GetNormals() && data->GetNumberOfCells() > 0 &&
         data->GetCellType(0) == VTK_TRIANGLE;
}

QString blockName(vtkMultiBlockDataSet* blocks, unsigned int i)
{
  return QString::fromUtf8(blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
}
}  // namespace

ScenePtr SceneDocument::open(const QString& path, bool turned)
{
  if (!studio::isBareMesh(path))
  {
    auto document = std::make_shared<SceneDocument>();
    document->Path = QFileInfo(path).absoluteFilePath();
    document->read(document->Path);
    document->complete();
    return document;
  }
  if (!QFileInfo(path).isFile())
    throw Problem(QStringLiteral("%1: file: no such file; expected a mesh").arg(path));
  return SceneDocument::fromDraft(draftOf(path), path, turned);
}

ScenePtr SceneDocument::fromDraft(const QJsonObject& draft, const QString& path, bool turned)
{
  auto document = std::make_shared<SceneDocument>();
  document->Path = QFileInfo(path).absoluteFilePath();
  document->BareMesh = studio::isBareMesh(path);
  const QTemporaryDir folder;
  const QString file = folder.filePath(QFileInfo(path).completeBaseName() + QStringLiteral(".json"));
  writeFile(file, QJsonDocument(draft).toJson());
  try
  {
    document->read(file);
  }
  catch (const Problem& problem)
  {
    throw Problem(problem.message().replace(file, path));
  }
  document->Turned = turned;
  if (turned)
    document->Surfaces = studio::turned(document->Surfaces);
  document->Outward = document->BareMesh && studio::facesOutward(document->Surfaces);
  document->complete();
  return document;
}

// What is derived from the content of the file.
void SceneDocument::complete()
{
  this->Painted = paintedSurface(this->Surfaces);
  this->Edges = singularEdges(this->Surfaces, false, this->receivers(this->sets()));
  this->Furnace = studio::furnaceIlluminance(this->Surfaces, this->Luminaires);
  this->refineShadows();
}

void SceneDocument::refineShadows()
{
  if (this->Painted.standIns)
    return;  // a large scene has enough to draw
  for (const NamedSet& set : dataSets(this->receivers(this->usualSets())))
    if (auto* data = vtkPolyData::SafeDownCast(set.data))
      this->Fine[set.name] = FineShadows::make(data, this->Surfaces, this->Luminaires, this->size() / 800);
}

void SceneDocument::read(const QString& sceneFile)
{
  vtkNew<vtkKalosSceneReader> reader;
  const auto errors = ErrorCollector::watch(reader);
  reader->SetFileName(sceneFile.toUtf8().constData());
  reader->Update();
  if (!errors->message().isEmpty())
    throw Problem(errors->message());
  this->Surfaces = reader->GetSurfaces();
  this->Luminaires = reader->GetLuminaires();
  this->FileReceivers = reader->GetReceivers();
  for (int i = 0; i < reader->GetNumberOfCameras(); ++i)
  {
    CameraPreset camera;
    camera.name = QString::fromStdString(reader->GetCameraName(i));
    reader->GetCameraPosition(i, camera.position.GetData());
    reader->GetCameraTarget(i, camera.target.GetData());
    reader->GetCameraUp(i, camera.up.GetData());
    camera.fieldOfView = reader->GetCameraFieldOfView(i);
    if (!isUnseen(camera.name))
      this->Cameras << camera;
  }
}

bool SceneDocument::hasGloss() const
{
  for (const char* name : {vtkKalosArrayNames::Specular, vtkKalosArrayNames::Mirror})
    if (vtkDataArray* array = this->Surfaces->GetCellData()->GetArray(name); array && array->GetRange()[1] > 0)
      return true;
  return false;
}

QString SceneDocument::name() const
{
  return QFileInfo(this->Path).fileName();
}

double SceneDocument::size() const
{
  return this->Surfaces->GetNumberOfPoints() > 0 ? this->Surfaces->GetLength() : 1;
}

QStringList SceneDocument::sets() const
{
  QStringList names;
  if (this->Painted.receivers->GetNumberOfCells() > 0)
    names << paintedName();
  for (unsigned int i = 0; i < this->FileReceivers->GetNumberOfBlocks(); ++i)
    names << blockName(this->FileReceivers, i);
  return names;
}

QStringList SceneDocument::usualSets() const
{
  QStringList names = this->sets();
  for (unsigned int i = 0; i < this->FileReceivers->GetNumberOfBlocks(); ++i)
    if (isSurfaceCut(this->FileReceivers->GetBlock(i)))
      names.removeAll(blockName(this->FileReceivers, i));
  return names;
}

vtkSmartPointer<vtkMultiBlockDataSet> SceneDocument::receivers(const QStringList& names) const
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  auto add = [&](const QString& name, vtkDataObject* data) {
    if (names.contains(name))
      addSet(blocks, name, data);
  };
  if (this->Painted.receivers->GetNumberOfCells() > 0)
    add(paintedName(), this->Painted.receivers);
  for (unsigned int i = 0; i < this->FileReceivers->GetNumberOfBlocks(); ++i)
    add(blockName(this->FileReceivers, i), this->FileReceivers->GetBlock(i));
  return blocks;
}
}  // namespace studio
