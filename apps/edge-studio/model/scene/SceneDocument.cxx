// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneDocument.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include "base/ErrorCollector.h"
#include "base/Problem.h"
#include "scene/BareMesh.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosSceneReader.h"
#include "vtkKalosSingularEdges.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
vtkSmartPointer<vtkPolyData> findEdges(vtkPolyData* surfaces, bool borders)
{
  vtkNew<vtkKalosSingularEdges> edges;
  const auto errors = ErrorCollector::watch(edges);
  edges->SetInputData(surfaces);
  edges->SetBorderEdges(borders);
  edges->Update();
  return edges->GetOutput();
}

/// The one value that all cells have in all components; none if they differ.
std::optional<double> uniform(vtkPolyData* surfaces, const char* name)
{
  vtkDataArray* array = surfaces->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() == 0)
    return {};
  const double first = array->GetComponent(0, 0);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      if (array->GetComponent(i, c) != first)
        return {};
  return first;
}

bool isClosed(vtkPolyData* surfaces)
{
  const auto edges = findEdges(surfaces, true);
  auto* classes =
      vtkIntArray::SafeDownCast(edges->GetCellData()->GetArray(vtkKalosSingularEdges::EdgeClassArrayName()));
  for (vtkIdType i = 0; classes && i < classes->GetNumberOfTuples(); ++i)
    if (classes->GetValue(i) == vtkKalosSingularEdges::BORDER)
      return false;
  return classes != nullptr;
}

/// White furnace: E = M0/(1 - rho), docs of the closed forms in python/kalos/truths.py.
std::optional<double> furnace(vtkPolyData* surfaces, vtkPolyData* luminaires)
{
  namespace Names = vtkKalosArrayNames;
  const auto reflectance = uniform(surfaces, Names::Reflectance), exitance = uniform(surfaces, Names::Exitance);
  for (const char* other : {Names::Specular, Names::Mirror})
    if (surfaces->GetCellData()->HasArray(other) && uniform(surfaces, other) != 0.0)
      return {};
  if (!reflectance || !exitance || !(*exitance > 0) || luminaires->GetNumberOfPoints() > 0 || !isClosed(surfaces))
    return {};
  return *exitance / (1 - *reflectance);
}

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

ScenePtr SceneDocument::open(const QString& path)
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
  }
  document->Edges = findEdges(document->Surfaces, false);
  document->Painted = paintedSurface(document->Surfaces);
  document->Furnace = furnace(document->Surfaces, document->Luminaires);
  return document;
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
    reader->GetCameraPosition(i, camera.position.data());
    reader->GetCameraTarget(i, camera.target.data());
    reader->GetCameraUp(i, camera.up.data());
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
    if (!names.contains(name))
      return;
    const unsigned int at = blocks->GetNumberOfBlocks();
    blocks->SetBlock(at, data);
    blocks->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), name.toUtf8().constData());
  };
  if (this->Painted.receivers->GetNumberOfCells() > 0)
    add(paintedName(), this->Painted.receivers);
  for (unsigned int i = 0; i < this->FileReceivers->GetNumberOfBlocks(); ++i)
    add(blockName(this->FileReceivers, i), this->FileReceivers->GetBlock(i));
  return blocks;
}
}  // namespace studio
