// SPDX-License-Identifier: BSD-3-Clause
#include "results/ResultFiles.h"

#include <QFileInfo>

#include "base/Files.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace studio
{
namespace
{
[[noreturn]] void refuse(const QString& path)
{
  throw Problem(QStringLiteral("%1: file: cannot be read; expected a result of the session").arg(path));
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

ResultPtr stored(const MethodSettings& settings, bool complete, vtkDataObject* data)
{
  auto result = std::make_shared<Result>(makeResult(settings, data));
  result->complete = complete;
  return result;
}
}  // namespace

void writeResult(const Result& result, const QString& path)
{
  writeData<vtkXMLMultiBlockDataWriter>(result.data, path);
}

ResultPtr readResult(const MethodSettings& settings, bool complete, const QString& path)
{
  const auto data = read<vtkXMLMultiBlockDataReader>(path);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  if (!blocks || blocks->GetNumberOfBlocks() == 0)
    refuse(path);
  // Each block has a copy of the field data.
  if (vtkDataObject* first = blocks->GetBlock(0))
    blocks->GetFieldData()->ShallowCopy(first->GetFieldData());
  return stored(settings, complete, blocks);
}

void writeImage(const Result& image, const QString& path)
{
  writeData<vtkXMLImageDataWriter>(image.data, path);
}

ResultPtr readImage(const MethodSettings& settings, const QString& path)
{
  const auto data = read<vtkXMLImageDataReader>(path);
  auto* image = vtkImageData::SafeDownCast(data);
  for (const char* name : {vtkKalosArrayNames::Luminance, vtkKalosArrayNames::LuminanceStandardError})
    if (!image || image->GetNumberOfPoints() == 0 || !image->GetPointData()->HasArray(name))
      refuse(path);
  return stored(settings, true, image);
}
}  // namespace studio
