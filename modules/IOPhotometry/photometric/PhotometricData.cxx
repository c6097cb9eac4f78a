// SPDX-License-Identifier: BSD-3-Clause
#include "PhotometricData.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace kalos::photometric
{
namespace
{
constexpr double degree = kalos::pi / 180;
constexpr int planeStep = 5, angleStep = 2;  // degrees, of the solid

std::optional<std::string> readText(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    return std::nullopt;
  }
  if (std::filesystem::file_size(path, error) > maxPhotometryBytes)
  {
    throw PhotometryError(1, "file", "larger than 16 MiB; expected a photometric file");
  }
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return file ? std::optional<std::string>(std::move(text)) : std::nullopt;
}

/** Towards half-plane C at angle gamma, with the photometric axis as z. */
Vec3 direction(double c, double gamma)
{
  const double s = std::sin(gamma * degree);
  return {s * std::cos(c * degree), s * std::sin(c * degree), std::cos(gamma * degree)};
}

vtkSmartPointer<vtkDoubleArray> newIntensity()
{
  auto intensity = vtkSmartPointer<vtkDoubleArray>::New();
  intensity->SetName(vtkKalosArrayNames::Intensity);
  return intensity;
}

std::string columnName(const CandelaTable& table, double plane)
{
  std::string number = std::to_string(plane);
  number.erase(number.find_last_not_of('0') + 1);
  number.erase(number.find_last_not_of('.') + 1);
  return (table.pole() == CandelaTable::Pole::Axis ? "C " : "V ") + number;
}
}  // namespace

PhotometricFile readFile(const std::string& path, int lampSet)
{
  const auto text = readText(path);
  if (!text)
  {
    throw PhotometryError(1, "file", "no such file, or not readable; expected a photometric file");
  }
  PhotometryOptions options;
  options.lampSet = lampSet;
  options.findTilt = [&](const std::string& name) {
    const std::string base = name.substr(name.find_last_of("/\\") + 1);
    return readText((std::filesystem::path(path).parent_path() / base).string());
  };
  return parsePhotometry(*text, options);
}

double intensity(const CandelaTable& table, double c, double gamma)
{
  return table.pole() == CandelaTable::Pole::Axis ? table.intensity(c, gamma) : table.intensity(direction(c, gamma));
}

void fillSolid(const CandelaTable& table, vtkPolyData* solid)
{
  constexpr int columns = 360 / planeStep, rows = 180 / angleStep + 1;
  vtkNew<vtkPoints> points;
  auto values = newIntensity();
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const double c = column * planeStep, gamma = row * angleStep;
      const double cd = intensity(table, c, gamma);
      const Vec3 p = cd / table.largest() * direction(c, gamma);
      points->InsertNextPoint(p.x, p.y, -p.z);
      values->InsertNextValue(cd);
    }
  }
  vtkNew<vtkCellArray> quads;
  for (vtkIdType row = 0; row + 1 < rows; ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      const vtkIdType next = (column + 1) % columns, a = row * columns, b = a + columns;
      const vtkIdType corners[4] = {a + column, b + column, b + next, a + next};
      quads->InsertNextCell(4, corners);
    }
  }
  solid->SetPoints(points);
  solid->SetPolys(quads);
  solid->GetPointData()->SetScalars(values);
}

void fillPolarCurves(const CandelaTable& table, vtkPolyData* curves)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  auto values = newIntensity();
  for (const double plane : {0.0, 90.0})
  {
    lines->InsertNextCell(361);
    for (int gamma = -180; gamma <= 180; ++gamma)
    {
      const double cd = intensity(table, gamma < 0 ? plane + 180 : plane, std::abs(gamma));
      const double r = cd / table.largest();
      lines->InsertCellPoint(points->InsertNextPoint(r * std::sin(gamma * degree), -r * std::cos(gamma * degree), 0));
      values->InsertNextValue(cd);
    }
  }
  curves->SetPoints(points);
  curves->SetLines(lines);
  curves->GetPointData()->SetScalars(values);
}

void fillTable(const CandelaTable& table, vtkTable* columns)
{
  const auto rows = static_cast<vtkIdType>(table.angles().size());
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("Angle");
  for (const double angle : table.angles())
  {
    angles->InsertNextValue(angle);
  }
  columns->AddColumn(angles);
  for (std::size_t p = 0; p < table.planes().size(); ++p)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(columnName(table, table.planes()[p]).c_str());
    for (vtkIdType a = 0; a < rows; ++a)
    {
      column->InsertNextValue(table.candela()[p * rows + a]);
    }
    columns->AddColumn(column);
  }
}
}  // namespace kalos::photometric
