// SPDX-License-Identifier: BSD-3-Clause
#include "results/Export.h"

#include <QDir>

#include "base/DataSets.h"
#include "base/Files.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosEXRWriter.h"
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
    const Point position = receiverPosition(data, i);
    QByteArrayList cells;
    for (int axis = 0; axis < 3; ++axis)
      cells << QByteArray::number(position[axis], 'g', 9);
    for (vtkDataArray* column : columns)
      for (int c = 0; c < column->GetNumberOfComponents(); ++c)
        cells << QByteArray::number(column->GetComponent(i, c), 'g', 9);
    text += cells.join(',') + '\n';
  }
  return text;
}
}  // namespace

QStringList exportedFiles(const Result& result, const QString& folder)
{
  QStringList paths;
  for (const NamedSet& set : dataSets(result.data))
    for (const char* suffix : {".csv", ".vtp"})
      paths << QDir(folder).filePath(set.name) + QLatin1String(suffix);
  return paths;
}

QStringList exportResult(const Result& result, const QString& folder)
{
  if (!QDir().mkpath(folder))
    throw Problem(QStringLiteral("%1: folder: cannot be made; expected a place that can be written").arg(folder));
  const QStringList paths = exportedFiles(result, folder);
  auto path = paths.begin();
  for (const NamedSet& set : dataSets(result.data))
  {
    writeFile(*path++, table(set.data));
    writeData<vtkXMLPolyDataWriter>(set.data, *path++);
  }
  return paths;
}

void exportImage(const Result& image, const QString& path)
{
  writeData<vtkKalosEXRWriter>(image.data, path);
}
}  // namespace studio
