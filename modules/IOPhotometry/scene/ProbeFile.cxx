// SPDX-License-Identifier: BSD-3-Clause
#include "ProbeFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "../base/InputError.h"
#include "SceneReceivers.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace kalos::scene
{
namespace
{
const char* const Header = "x,y,z,nx,ny,nz";

/** Six finite numbers between commas, or false. */
bool parseRow(const std::string& line, std::array<double, 6>& row)
{
  std::istringstream text(line);
  text.imbue(std::locale::classic());
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    char comma = ',';
    if ((i > 0 && !(text >> comma)) || comma != ',' || !(text >> row[i]) || !std::isfinite(row[i]))
    {
      return false;
    }
  }
  return (text >> std::ws).eof();
}

/** Reads the next line; one that is too long is an error. False at the end of the file. */
bool nextLine(std::istream& file, std::string& line, const std::string& path, long long number)
{
  std::array<char, MaximumProbeLine + 1> buffer;
  file.getline(buffer.data(), buffer.size());
  const auto count = static_cast<std::size_t>(file.gcount());
  if (file.fail() && count > 0)
  {
    throw InputError(path, "line " + std::to_string(number),
                     "longer than " + std::to_string(MaximumProbeLine) + " bytes; expected " + Header);
  }
  line.assign(buffer.data(), file.eof() ? count : count - std::min<std::size_t>(count, 1));
  return !file.fail();
}

/** Normalizes any finite vector, even if its square overflows; false for zero. */
bool makeUnit(double* vector)
{
  const double largest = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  for (int i = 0; largest > 0.0 && i < 3; ++i)
  {
    vector[i] /= largest;
  }
  return vtkMath::Normalize(vector) > 0.0;
}
/** The receivers as they are read. */
struct Receivers
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkDoubleArray> normals;

  Receivers()
  {
    this->points->SetDataTypeToDouble();
    this->normals->SetName("Normals");
    this->normals->SetNumberOfComponents(3);
  }

  void add(std::array<double, 6>& row)
  {
    const vtkIdType id = this->points->InsertNextPoint(row.data());
    this->vertices->InsertNextCell(1, &id);
    this->normals->InsertNextTuple(&row[3]);
  }
};

/** Throws with what is wrong and expected. */
void readLine(const std::string& line, std::int64_t most, Receivers& receivers)
{
  std::array<double, 6> row;
  if (!parseRow(line, row))
  {
    throw std::invalid_argument(std::string("not a receiver; expected six finite numbers ") + Header);
  }
  if (!makeUnit(&row[3]))
  {
    throw std::invalid_argument("the normal is zero; expected a direction");
  }
  if (receivers.points->GetNumberOfPoints() >= most)
  {
    throw std::invalid_argument("one receiver too many; expected " + fewerReceivers(most));
  }
  receivers.add(row);
}

void checkHeader(std::string line)
{
  const bool marked = line.compare(0, 3, "\xEF\xBB\xBF") == 0;
  line.erase(0, marked ? 3 : 0);
  line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
  if (line != Header)
  {
    throw std::invalid_argument(std::string("the header is not as it should be; expected ") + Header);
  }
}
}  // namespace

vtkSmartPointer<vtkPolyData> readProbeFile(const JsonCursor& place, const std::string& path, std::int64_t most)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    place.fail("no file " + path + "; expected a CSV file, its path relative to the scene file");
  }
  Receivers receivers;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (long long number = 1; nextLine(file, line, path, number); ++number)
  {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    try
    {
      if (number == 1)
      {
        checkHeader(line);
      }
      else if (!line.empty())
      {
        readLine(line, most, receivers);
      }
    }
    catch (const std::invalid_argument& error)
    {
      throw InputError(path, "line " + std::to_string(number), error.what());
    }
  }
  if (receivers.points->GetNumberOfPoints() == 0)
  {
    throw InputError(path, "file",
                     std::string("no receivers; expected the header ") + Header + " and at least one line");
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(receivers.points);
  data->SetVerts(receivers.vertices);
  data->GetPointData()->SetNormals(receivers.normals);
  return data;
}
}  // namespace kalos::scene
