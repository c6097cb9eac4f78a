// SPDX-License-Identifier: BSD-3-Clause
#include "results/DiffuseLuminance.h"

#include <QtMath>

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

/// vtkKalosArrayNames.h: one band is photometric, three are Rec. 709, any other number have equal shares.
double bandShare(int band, int bands)
{
  constexpr double rec709[] = {0.2126, 0.7152, 0.0722};
  return bands == 3 ? rec709[band] : 1.0 / bands;
}

vtkSmartPointer<vtkDoubleArray> newColumn(const char* name, vtkIdType size)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(size);
  return array;
}
}  // namespace

void addDiffuseLuminance(vtkDataSet* dataSet)
{
  vtkCellData* cells = dataSet->GetCellData();
  vtkDataArray *reflectance = cells->GetArray(Names::Reflectance), *lux = cells->GetArray(Names::Illuminance),
               *error = cells->GetArray(Names::IlluminanceStandardError), *exitance = cells->GetArray(Names::Exitance);
  if (!reflectance || !lux || !error || cells->HasArray(Names::Luminance))
    return;
  const int bands = reflectance->GetNumberOfComponents();
  vtkDataArray* illuminance = bands > 1 ? cells->GetArray(Names::IlluminanceBands) : lux;
  if (!illuminance || illuminance->GetNumberOfComponents() != bands)
    return;
  const bool emits = exitance && exitance->GetNumberOfComponents() == bands;
  const auto luminance = newColumn(Names::Luminance, lux->GetNumberOfTuples()),
             uncertainty = newColumn(Names::LuminanceStandardError, lux->GetNumberOfTuples());
  vtkNew<vtkDoubleArray> colour;
  colour->SetName(Names::LuminanceBands);
  colour->SetNumberOfComponents(bands);
  colour->SetNumberOfTuples(lux->GetNumberOfTuples());
  for (vtkIdType i = 0; i < lux->GetNumberOfTuples(); ++i)
  {
    double reflected = 0, emitted = 0;
    for (int b = 0; b < bands; ++b)
    {
      const double sent = reflectance->GetComponent(i, b) * illuminance->GetComponent(i, b),
                   own = emits ? exitance->GetComponent(i, b) : 0;
      reflected += bandShare(b, bands) * sent;
      emitted += bandShare(b, bands) * own;
      colour->SetComponent(i, b, (sent + own) / M_PI);
    }
    const double value = lux->GetComponent(i, 0);
    luminance->SetValue(i, (reflected + emitted) / M_PI);
    uncertainty->SetValue(i, value > 0 ? reflected / M_PI * error->GetComponent(i, 0) / value : 0);
  }
  cells->AddArray(luminance);
  cells->AddArray(uncertainty);
  if (bands > 1)
    cells->AddArray(colour);
}
}  // namespace studio
