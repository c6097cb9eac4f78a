// SPDX-License-Identifier: BSD-3-Clause
#include "results/Colours.h"

#include "vtkKalosFalseColor.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
using Rgb = std::array<double, 3>;

/// Straight lines between colours at equal distances.
vtkSmartPointer<vtkLookupTable> ramp(const std::vector<Rgb>& stops)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    const double at = i / 255.0 * static_cast<double>(stops.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double t = at - static_cast<double>(k);
    Rgb c;
    for (int j = 0; j < 3; ++j)
      c[j] = (1 - t) * stops[k][j] + t * stops[k + 1][j];
    table->SetTableValue(i, c[0], c[1], c[2]);
  }
  return table;
}

void setScale(vtkLookupTable* table, double low, double high, bool logarithmic)
{
  table->SetScaleToLinear();
  table->SetTableRange(low, high);
  table->SetScale(logarithmic ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
}
}  // namespace

QStringList colourMaps()
{
  return {QStringLiteral("kalos"), QStringLiteral("viridis"), QStringLiteral("inferno"), QStringLiteral("grey")};
}

vtkSmartPointer<vtkLookupTable> falseColours(const std::array<double, 2>& range, bool logarithmic, const QString& map)
{
  vtkSmartPointer<vtkLookupTable> table;
  if (map == QLatin1String("viridis"))
    table = ramp({{0.267, 0.005, 0.329},
                  {0.275, 0.196, 0.494},
                  {0.212, 0.361, 0.553},
                  {0.153, 0.498, 0.557},
                  {0.122, 0.631, 0.529},
                  {0.290, 0.757, 0.427},
                  {0.627, 0.855, 0.224},
                  {0.993, 0.906, 0.144}});
  else if (map == QLatin1String("inferno"))
    table = ramp({{0.001, 0.000, 0.014},
                  {0.157, 0.043, 0.330},
                  {0.396, 0.082, 0.431},
                  {0.623, 0.165, 0.388},
                  {0.831, 0.282, 0.259},
                  {0.961, 0.490, 0.082},
                  {0.980, 0.757, 0.153},
                  {0.988, 1.000, 0.644}});
  else if (map == QLatin1String("grey"))
    table = ramp({{0.05, 0.05, 0.05}, {1, 1, 1}});
  else
  {
    vtkNew<vtkKalosFalseColor> source;
    table = vtkSmartPointer<vtkLookupTable>::New();
    table->DeepCopy(source->GetLookupTable());
  }
  setScale(table, range[0], range[1], logarithmic);
  return table;
}

vtkSmartPointer<vtkLookupTable> differenceColours(double limit)
{
  const auto table =
      ramp({{0.02, 0.19, 0.38}, {0.26, 0.58, 0.76}, {0.97, 0.97, 0.97}, {0.84, 0.38, 0.30}, {0.40, 0.0, 0.12}});
  setScale(table, -limit, limit, false);
  return table;
}

vtkSmartPointer<vtkLookupTable> severityColours()
{
  const auto table = ramp({{0.35, 0.55, 0.60}, {0.20, 0.85, 0.80}, {0.80, 1.0, 0.95}});
  setScale(table, 0.01, 10, true);
  return table;
}
}  // namespace studio
