// SPDX-License-Identifier: BSD-3-Clause
#include "results/Result.h"

#include <cmath>

#include "base/DataSets.h"
#include "results/DiffuseLuminance.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

Quality qualityOf(vtkDataObject* data)
{
  Quality quality;
  double squares = 0;
  qint64 lit = 0;
  for (const NamedSet& set : dataSets(data))
  {
    vtkDataArray *value = arrayOf(set.data, Names::Illuminance),
                 *error = arrayOf(set.data, Names::IlluminanceStandardError),
                 *trusted = arrayOf(set.data, Names::IntervalTrusted), *valid = arrayOf(set.data, Names::Valid);
    if (!value)  // an image
    {
      value = arrayOf(set.data, Names::Luminance);
      error = arrayOf(set.data, Names::LuminanceStandardError);
    }
    if (!value || !error || !trusted)
      continue;
    for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
    {
      if (valid && valid->GetComponent(i, 0) == 0)
      {
        ++quality.invalid;
        continue;
      }
      ++quality.receivers;
      quality.untrusted += trusted->GetComponent(i, 0) == 0;
      if (!(value->GetComponent(i, 0) > 0))
        continue;
      const double relative = error->GetComponent(i, 0) / value->GetComponent(i, 0);
      quality.largest = std::max(quality.largest, relative);
      squares += relative * relative;
      ++lit;
    }
  }
  quality.typical = lit > 0 ? std::sqrt(squares / static_cast<double>(lit)) : 0;
  return quality;
}

void addErrors(vtkDataSet* data)
{
  vtkDataArray *value = arrayOf(data, Names::Illuminance), *error = arrayOf(data, Names::IlluminanceStandardError),
               *trusted = arrayOf(data, Names::IntervalTrusted);
  if (!value || !error || !trusted)
    return;
  vtkNew<vtkDoubleArray> relative, untrusted;
  relative->SetName(relativeErrorName);
  untrusted->SetName(untrustedName);
  for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
  {
    const double lux = value->GetComponent(i, 0);
    relative->InsertNextValue(lux > 0 ? 100 * error->GetComponent(i, 0) / lux : 0);
    untrusted->InsertNextValue(trusted->GetComponent(i, 0) == 0);
  }
  const bool ofPoints = data->GetPointData()->HasArray(Names::Illuminance);
  vtkDataSetAttributes* attributes = data->GetCellData();
  if (ofPoints)
    attributes = data->GetPointData();
  attributes->AddArray(relative);
  attributes->AddArray(untrusted);
}

double fieldValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0;
}
}  // namespace

vtkDataSet* Result::set(const QString& wanted) const
{
  for (const NamedSet& set : dataSets(this->data))
    if (set.name == wanted || set.name.isEmpty())
      return set.data;
  return nullptr;
}

Result makeResult(const MethodSettings& settings, vtkDataObject* data)
{
  Result result;
  result.settings = settings;
  result.data = data;
  for (const NamedSet& set : dataSets(data))
  {
    addDiffuseLuminance(set.data);
    addErrors(set.data);
  }
  result.quality = qualityOf(data);
  result.trajectories = static_cast<qint64>(fieldValue(data, Names::Trajectories));
  result.seconds = fieldValue(data, Names::SolveSeconds);
  result.cpuSeconds = fieldValue(data, Names::SolveCpuSeconds);
  return result;
}

vtkDataArray* arrayOf(vtkDataSet* dataSet, const char* name)
{
  vtkDataArray* array = dataSet->GetPointData()->GetArray(name);
  return array ? array : dataSet->GetCellData()->GetArray(name);
}

Point receiverPosition(vtkDataSet* dataSet, vtkIdType receiver)
{
  if (dataSet->GetPointData()->GetArray(Names::Illuminance))
    return Point(dataSet->GetPoint(receiver));
  return cellCentre(dataSet, receiver);
}
}  // namespace studio
