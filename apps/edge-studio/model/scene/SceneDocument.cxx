// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneDocument.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include "base/DataSets.h"
#include "base/ErrorCollector.h"
#include "base/Problem.h"
#include "scene/BareMesh.h"
#include "scene/Furnace.h"
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
  auto document = std::make_shared<SceneDocument>();
  document->Path = QFileInfo(path).absoluteFilePath();
  document->BareMesh = studio::isBareMesh(path);
  if (!document->BareMesh)
    document->read(document->Path);
  else
  {
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("furnace.json")));
    if (!QFileInfo(path).isFile())
      throw Problem(QStringLiteral("%1: file: no such file; expected a mesh").arg(path));
    if (!file.open(QIODevice::WriteOnly))
      throw Problem(QStringLiteral("%1: file: cannot be written; expected a writable folder").arg(file.fileName()));
    file.write(furnaceAround(path));
    file.close();
    document->read(file.fileName());
    document->Cameras.clear();
    document->Turned = turned;
    if (turned)
      document->Surfaces = studio::turned(document->Surfaces);
    document->Outward = studio::facesOutward(document->Surfaces);
  }
  document->Edges = singularEdges(document->Surfaces, false);
  document->Painted = paintedSurface(document->Surfaces);
  document->Furnace = studio::furnaceIlluminance(document->Surfaces, document->Luminaires);
  document->refineShadows();
  return document;
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
