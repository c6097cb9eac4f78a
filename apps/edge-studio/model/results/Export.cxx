// SPDX-License-Identifier: BSD-3-Clause
#include "results/Export.h"

#include <QDir>
#include <QSaveFile>

#include "base/DataSets.h"
#include "base/ErrorCollector.h"
#include "base/Problem.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosEXRWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataWriter.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

QByteArray table(vtkDataSet* data)
{
  const bool ofPoints = data->GetPointData()->HasArray(Names::Illuminance);
  vtkDataArray* columns[] = {ofPoints ? data->GetPointData()->GetNormals() : data->GetCellData()->GetNormals(),
                             arrayOf(data, Names::Illuminance), arrayOf(data, Names::IlluminanceStandardError),
                             arrayOf(data, Names::DirectIlluminance)};
  QByteArray text = "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,direct_lx\n";
  for (vtkIdType i = 0; i < columns[1]->GetNumberOfTuples(); ++i)
  {
    double position[3];
    receiverPosition(data, i, position);
    QByteArrayList cells;
    for (double coordinate : position)
      cells << QByteArray::number(coordinate, 'g', 9);
    for (vtkDataArray* column : columns)
      for (int c = 0; c < column->GetNumberOfComponents(); ++c)
        cells << QByteArray::number(column->GetComponent(i, c), 'g', 9);
    text += cells.join(',') + '\n';
  }
  return text;
}

void writeText(const QString& path, const QByteArray& text)
{
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
    throw Problem(QStringLiteral("%1: file: %2; expected a place that can be written").arg(path, file.errorString()));
}

void writeData(const QString& path, vtkDataSet* data)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  const auto errors = ErrorCollector::watch(writer);
  writer->SetInputData(data);
  writer->SetFileName(path.toUtf8().constData());
  writer->SetDataModeToBinary();  // as in ResultFiles.cxx
  if (!writer->Write() || !errors->message().isEmpty())
    throw Problem(QStringLiteral("%1: file: can not be written; expected a writable folder").arg(path));
}
}  // namespace

QStringList exportResult(const Result& result, const QString& folder)
{
  if (!QDir().mkpath(folder))
    throw Problem(QStringLiteral("%1: folder: can not be made; expected a writable place").arg(folder));
  QStringList paths;
  for (const NamedSet& set : dataSets(result.data))
  {
    const QString stem = QDir(folder).filePath(set.name);
    writeText(stem + QStringLiteral(".csv"), table(set.data));
    writeData(stem + QStringLiteral(".vtp"), set.data);
    paths << stem + QStringLiteral(".csv") << stem + QStringLiteral(".vtp");
  }
  return paths;
}

void exportImage(const Result& image, const QString& path)
{
  vtkNew<vtkKalosEXRWriter> writer;
  const auto errors = ErrorCollector::watch(writer);
  writer->SetInputDataObject(image.data);
  writer->SetFileName(path.toUtf8().constData());
  if (!writer->Write() || !errors->message().isEmpty())
    throw Problem(errors->message().isEmpty()
                      ? QStringLiteral("%1: file: can not be written; expected a place that can be written").arg(path)
                      : errors->message());
}
}  // namespace studio
