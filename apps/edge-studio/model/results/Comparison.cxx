// SPDX-License-Identifier: BSD-3-Clause
#include "results/Comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/DataSets.h"
#include "results/Display.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace studio
{
Comparison compare(const Result& a, const Result& b)
{
  namespace Names = vtkKalosArrayNames;
  Comparison comparison;
  comparison.independent = a.settings.seed != b.settings.seed;
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  double sumA = 0, sumB = 0;
  qint64 beyond = 0;
  for (const NamedSet& set : dataSets(a.data))
  {
    vtkDataSet* other = b.set(set.name);
    vtkDataArray *valueA = arrayOf(set.data, Names::Illuminance),
                 *valueB = other ? arrayOf(other, Names::Illuminance) : nullptr;
    if (!valueA || !valueB || valueA->GetNumberOfTuples() != valueB->GetNumberOfTuples())
      continue;
    vtkDataArray *errorA = arrayOf(set.data, Names::IlluminanceStandardError),
                 *errorB = arrayOf(other, Names::IlluminanceStandardError);
    vtkNew<vtkDoubleArray> inErrors, inLux, inPercent;
    inErrors->SetName(Comparison::inErrors);
    inLux->SetName(Comparison::inLux);
    inPercent->SetName(Comparison::inPercent);
    for (vtkIdType i = 0; i < valueA->GetNumberOfTuples(); ++i)
    {
      const double more = valueA->GetComponent(i, 0) - valueB->GetComponent(i, 0);
      const double error = std::hypot(errorA->GetComponent(i, 0), errorB->GetComponent(i, 0));
      const double units = error > 0 ? more / error : more == 0 ? 0 : std::copysign(1e6, more);
      inErrors->InsertNextValue(units);
      inLux->InsertNextValue(more);
      inPercent->InsertNextValue(valueB->GetComponent(i, 0) > 0 ? 100 * more / valueB->GetComponent(i, 0) : 0);
      beyond += std::abs(units) > 2;
      sumA += valueA->GetComponent(i, 0);
      sumB += valueB->GetComponent(i, 0);
      ++comparison.receivers;
    }
    auto copy = vtk::TakeSmartPointer(set.data->NewInstance());
    copy->CopyStructure(set.data);
    const bool ofPoints = set.data->GetPointData()->HasArray(Names::Illuminance);
    for (vtkDoubleArray* array : {inErrors.Get(), inLux.Get(), inPercent.Get()})
      (ofPoints ? static_cast<vtkDataSetAttributes*>(copy->GetPointData()) : copy->GetCellData())->AddArray(array);
    addSet(blocks, set.name, copy);
  }
  comparison.data = blocks;
  if (comparison.receivers > 0)
    comparison.beyondTwo = static_cast<double>(beyond) / static_cast<double>(comparison.receivers);
  comparison.meanDifference = sumB > 0 ? sumA / sumB - 1 : 0;
  return comparison;
}

double colourLimit(const Comparison& comparison, const char* array)
{
  if (array == Comparison::inErrors)
    return 5;
  std::vector<double> sizes;
  for (const NamedSet& set : dataSets(comparison.data))
    if (vtkDataArray* values = arrayOf(set.data, array))
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
        sizes.push_back(std::abs(values->GetComponent(i, 0)));
  if (sizes.empty())
    return 1;
  const auto high = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), high, sizes.end());
  return *high > 0 ? roundUp(*high) : 1;
}

namespace
{
/// truth(set, receiver): the true value there, or nothing.
template <class Truth>
Deviation deviation(const Result& result, const Truth& truth)
{
  double squares = 0, sum = 0, total = 0;
  qint64 count = 0;
  for (const NamedSet& set : dataSets(result.data))
  {
    vtkDataArray* lux = arrayOf(set.data, vtkKalosArrayNames::Illuminance);
    for (vtkIdType i = 0; lux && i < lux->GetNumberOfTuples(); ++i)
      if (const std::optional<double> known = truth(set.name, i))
      {
        const double off = lux->GetComponent(i, 0) - *known;
        squares += off * off;
        sum += off;
        total += *known;
        ++count;
      }
  }
  if (!(total > 0))
    return {};
  const double mean = total / static_cast<double>(count);
  return {std::sqrt(squares / static_cast<double>(count)) / mean, sum / total};
}
}  // namespace

Deviation deviationFrom(double truth, const Result& result)
{
  return deviation(result, [&](const QString&, vtkIdType) { return std::optional<double>(truth); });
}

Deviation deviationFrom(const Result& reference, const Result& result)
{
  return deviation(result, [&](const QString& name, vtkIdType i) -> std::optional<double> {
    vtkDataSet* set = reference.set(name);
    vtkDataArray* lux = set ? arrayOf(set, vtkKalosArrayNames::Illuminance) : nullptr;
    return lux && i < lux->GetNumberOfTuples() ? std::optional<double>(lux->GetComponent(i, 0)) : std::nullopt;
  });
}
}  // namespace studio
