// SPDX-License-Identifier: BSD-3-Clause
#include "results/AuditLines.h"

#include <algorithm>

#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkStringArray.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

/// The tuples of three strings of an array of field data.
QVector<AuditLine> triples(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data ? data->GetFieldData()->GetAbstractArray(name) : nullptr);
  QVector<AuditLine> lines;
  for (vtkIdType i = 0; array && i + 2 < array->GetNumberOfValues(); i += 3)
    lines.append({QString::fromStdString(array->GetValue(i)), QString::fromStdString(array->GetValue(i + 1)),
                  QString::fromStdString(array->GetValue(i + 2)), false});
  return lines;
}
}  // namespace

QVector<AuditLine> auditLines(const SceneDocument& scene, const Result* result)
{
  QVector<AuditLine> lines;
  for (AuditLine line : triples(scene.luminaires(), Names::PhotometryWarnings))  // code, file, message
  {
    std::swap(line.choice, line.reason);
    line.warning = true;
    lines << line;
  }
  for (AuditLine line : triples(result ? result->data.Get() : nullptr, Names::Audit))
  {
    line.warning = line.subject == QLatin1String("warning");
    lines << line;
  }
  lines += triples(scene.surfaces(), Names::SceneNotes);
  std::stable_partition(lines.begin(), lines.end(), [](const AuditLine& line) { return line.warning; });
  return lines;
}
}  // namespace studio
