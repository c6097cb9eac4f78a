// SPDX-License-Identifier: BSD-3-Clause
#include "results/ResultFiles.h"

#include <QFileInfo>

#include "base/ErrorCollector.h"
#include "base/Problem.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace studio
{
namespace
{
template <class Writer>
void write(vtkDataObject* data, const QString& path)
{
  vtkNew<Writer> writer;
  const auto errors = ErrorCollector::watch(writer);
  writer->SetInputDataObject(data);
  writer->SetFileName(path.toUtf8().constData());
  writer->SetDataModeToBinary();  // raw appended data: VTK 9.2 can not read it with expat 2.5.0-1+deb12u2 and later
  if (!writer->Write() || !errors->message().isEmpty())
    throw Problem(QStringLiteral("%1: file: can not be written; expected a writable folder").arg(path));
}

[[noreturn]] void refuse(const QString& path)
{
  throw Problem(QStringLiteral("%1: file: can not be read; expected a result of the session").arg(path));
}

template <class Reader>
vtkSmartPointer<vtkDataObject> read(const QString& path)
{
  vtkNew<Reader> reader;
  const auto errors = ErrorCollector::watch(reader);
  if (!QFileInfo(path).isFile())
    throw Problem(QStringLiteral("%1: file: no such file; expected a result of the session").arg(path));
  reader->SetFileName(path.toUtf8().constData());
  reader->Update();
  if (!errors->message().isEmpty())
    refuse(path);
  return reader->GetOutputDataObject(0);
}

ResultPtr complete(const MethodSettings& settings, vtkDataObject* data)
{
  auto result = std::make_shared<Result>(makeResult(settings, data));
  result->complete = true;
  return result;
}
}  // namespace

void writeResult(const Result& result, const QString& path)
{
  write<vtkXMLMultiBlockDataWriter>(result.data, path);
}

ResultPtr readResult(const MethodSettings& settings, const QString& path)
{
  const auto data = read<vtkXMLMultiBlockDataReader>(path);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  if (!blocks || blocks->GetNumberOfBlocks() == 0)
    refuse(path);
  // The field data of the whole stand at each block too.
  if (vtkDataObject* first = blocks->GetBlock(0))
    blocks->GetFieldData()->ShallowCopy(first->GetFieldData());
  return complete(settings, blocks);
}

void writeImage(const Result& image, const QString& path)
{
  write<vtkXMLImageDataWriter>(image.data, path);
}

ResultPtr readImage(const MethodSettings& settings, const QString& path)
{
  const auto data = read<vtkXMLImageDataReader>(path);
  auto* image = vtkImageData::SafeDownCast(data);
  for (const char* name : {vtkKalosArrayNames::Luminance, vtkKalosArrayNames::LuminanceStandardError})
    if (!image || image->GetNumberOfPoints() == 0 || !image->GetPointData()->HasArray(name))
      refuse(path);
  return complete(settings, image);
}
}  // namespace studio
