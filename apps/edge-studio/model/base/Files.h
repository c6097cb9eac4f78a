// SPDX-License-Identifier: BSD-3-Clause
// Writes files, and throws Problem where that fails.
#ifndef studio_Files_h
#define studio_Files_h

#include <QByteArray>
#include <QString>

#include "base/ErrorCollector.h"
#include "base/Problem.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkXMLWriter.h"

class QSaveFile;

namespace studio
{
/// Opens a file and hands it these bytes; it is replaced as a whole by its commit().
void fillFile(QSaveFile& file, const QByteArray& bytes);
void commitFile(QSaveFile& file);

/// Both at once.
void writeFile(const QString& path, const QByteArray& bytes);

/// Writes a data object with one of VTK's writers.
template <class Writer>
void writeData(vtkDataObject* data, const QString& path)
{
  vtkNew<Writer> writer;
  const auto errors = ErrorCollector::watch(writer);
  writer->SetInputDataObject(data);
  writer->SetFileName(path.toUtf8().constData());
  if (auto* xml = vtkXMLWriter::SafeDownCast(writer.Get()))
    xml->SetDataModeToBinary();  // VTK 9.2 cannot read raw appended data with expat 2.5.0-1+deb12u2 and later
  if (writer->Write() && errors->message().isEmpty())
    return;
  if (errors->message().startsWith(path))
    throw Problem(errors->message());
  throw Problem(QStringLiteral("%1: file: cannot be written; expected a folder that can be written").arg(path));
}
}  // namespace studio

#endif
