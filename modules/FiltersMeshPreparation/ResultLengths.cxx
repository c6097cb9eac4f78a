// SPDX-License-Identifier: BSD-3-Clause
#include "ResultLengths.h"

#include <algorithm>
#include <cmath>

#include "mesh/SortedSides.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

namespace kalos
{
namespace
{
using meshing::Point;
using meshing::Side;
using meshing::TriangleMesh;

constexpr double Finest = 1.0 / 8;  // of the edge length

std::vector<double> values(vtkDataArray* array)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!std::isfinite(values[i]))
    {
      throw std::invalid_argument("cell " + std::to_string(i) + " of " + array->GetName() +
                                  " is NaN or infinite; expected a number");
    }
  }
  return values;
}

Point centre(const TriangleMesh& mesh, std::uint32_t t)
{
  const meshing::Triangle& c = mesh.triangles[t];
  return (1.0 / 3.0) * (mesh.points[c[0]] + mesh.points[c[1]] + mesh.points[c[2]]);
}
}  // namespace

std::vector<double> lengthsForResult(vtkPolyData* input, const TriangleMesh& mesh, const std::string& name,
                                     double change, double edgeLength)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("no cell array " + name + " of 1 component; expected a previous result");
  }
  const std::vector<double> value = values(array);
  vtkDataArray* errors = input->GetCellData()->GetArray((name + "StandardError").c_str());
  const std::vector<double> error = errors ? values(errors) : std::vector<double>(value.size(), 0.0);

  // Slopes between neighbours, and the mean over the surface.
  std::vector<double> slope(value.size(), 0.0);
  const std::vector<Side> sides = meshing::sortedSides(mesh);
  meshing::forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first + 1; i < last; ++i)
    {
      const std::uint32_t a = mesh.origin[sides[first].triangle], b = mesh.origin[sides[i].triangle];
      const double distance = norm(centre(mesh, sides[first].triangle) - centre(mesh, sides[i].triangle));
      if (a == b || !(distance > 0.0))
      {
        continue;
      }
      const double found = std::abs(value[a] - value[b]) / distance;
      slope[a] = std::max(slope[a], found);
      slope[b] = std::max(slope[b], found);
    }
  });
  double sum = 0.0, area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const double weight = norm(doubledArea(mesh, mesh.triangles[t]));
    sum += weight * std::abs(value[mesh.origin[t]]);
    area += weight;
  }
  const double allowed = change * sum / area;

  std::vector<double> lengths(value.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const double expected = edgeLength * slope[i] + std::abs(error[i]);
    lengths[i] = edgeLength * (expected > allowed ? std::max(Finest, allowed / expected) : 1.0);
  }
  return lengths;
}
}  // namespace kalos
