// SPDX-License-Identifier: BSD-3-Clause
#include "LuminaireConversion.h"

#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "ConversionErrors.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayLengths.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosCandelaText.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace
{
namespace Names = vtkKalosArrayNames;

constexpr double largestDistribution = 1e6;  // luminaires may have as many candela tables

kalos::Vec3 ReadVector(vtkPolyData* luminaires, const char* name, vtkIdType i, const kalos::Vec3& absent)
{
  vtkDataArray* array = luminaires->GetPointData()->GetArray(name);
  if (!array)
    return absent;
  if (array->GetNumberOfComponents() != 3)
    throw std::invalid_argument(std::string(name) + ": has " + std::to_string(array->GetNumberOfComponents()) +
                                " components, expected 3");
  const kalos::Vec3 v = ToVec3(array->GetTuple3(i));
  if (!kalos::isFinite(v))
    Refuse(name, "luminaire", i, "must be finite");
  return v;
}

/// A table of tuples (plane, angle, candela), one after the other; `name` is for messages.
std::shared_ptr<const kalos::CandelaTable> MakeTable(const std::string& name, const std::vector<double>& tuples,
                                                     bool side)
{
  std::vector<double> planes, angles, candela;
  bool inOrder = true;
  for (std::size_t i = 0; i < tuples.size() / 3; ++i)
  {
    const double plane = tuples[3 * i], angle = tuples[3 * i + 1];
    if (planes.empty() || plane != planes.back())
    {
      inOrder = inOrder && (planes.empty() || plane > planes.back()) && std::isfinite(plane);
      planes.push_back(plane);
    }
    if (planes.size() == 1)
    {
      inOrder = inOrder && (angles.empty() ? angle >= 0 : angle > angles.back()) && angle <= 180;
      angles.push_back(angle);
    }
    candela.push_back(tuples[3 * i + 2]);
    inOrder = inOrder && angle == angles[(candela.size() - 1) % angles.size()];
    if (!(candela.back() >= 0 && std::isfinite(candela.back())))
      Refuse(name.c_str(), "tuple", static_cast<vtkIdType>(i),
             "is " + std::to_string(candela.back()) + " cd, expected 0 or more");
  }
  if (!inOrder || planes.size() < 2 || angles.size() < 2 || candela.size() != planes.size() * angles.size() ||
      planes.back() - planes.front() > 360)
    throw std::invalid_argument(name + ": expected ascending planes of up to 360 deg, and in each the same ascending " +
                                "angles from 0 to 180 deg");
  auto table = std::make_shared<kalos::CandelaTable>(
      planes, angles, candela, side ? kalos::CandelaTable::Pole::Side : kalos::CandelaTable::Pole::Axis);
  if (!(table->flux() > 0))
    throw std::invalid_argument(name + ": every intensity is 0, expected a luminaire that shines");
  return table;
}

/// Table k of the field data; see vtkKalosArrayNames::CandelaTable.
std::shared_ptr<const kalos::CandelaTable> ReadFieldTable(vtkPolyData* luminaires, int k)
{
  const std::string name = Names::CandelaTable + std::to_string(k);
  vtkDataArray* array = luminaires->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 3)
    throw std::invalid_argument(name + ": the field data array is missing, expected tuples of plane, angle, candela");
  vtkDataArray* poles = luminaires->GetFieldData()->GetArray(Names::CandelaPoles);
  const bool side = poles && poles->GetNumberOfTuples() > k && poles->GetComponent(k, 0) != 0;
  std::vector<double> tuples(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    array->GetTuple(i, &tuples[3 * i]);
  return MakeTable(name, tuples, side);
}

/// The tables of luminaires, each made once: of the point array CandelaTables, else of the field data.
class Tables
{
public:
  explicit Tables(vtkPolyData* luminaires)
      : Luminaires(luminaires),
        Texts(vtkStringArray::SafeDownCast(luminaires->GetPointData()->GetAbstractArray(Names::CandelaTables)))
  {
  }

  std::shared_ptr<const kalos::CandelaTable> of(vtkIdType luminaire, int k)
  {
    const std::string text = this->Texts ? std::string(this->Texts->GetValue(luminaire)) : std::string();
    auto& table = text.empty() ? this->ByNumber[k] : this->ByText[text];
    if (!table)
      table = text.empty() ? ReadFieldTable(this->Luminaires, k) : Parse(text, luminaire);
    return table;
  }

private:
  static std::shared_ptr<const kalos::CandelaTable> Parse(const std::string& text, vtkIdType luminaire)
  {
    std::vector<double> tuples;
    bool side = false;
    if (!vtkKalosCandelaText::Read(text, tuples, side))
      Refuse(Names::CandelaTables, "luminaire", luminaire,
             "is no candela table, expected a text of vtkKalosLuminaireSource");
    return MakeTable(Names::CandelaTables, tuples, side);
  }

  vtkPolyData* Luminaires;
  vtkStringArray* Texts;
  std::map<int, std::shared_ptr<const kalos::CandelaTable>> ByNumber;
  std::map<std::string, std::shared_ptr<const kalos::CandelaTable>> ByText;
};

/// Unit vector across the axis; without an array, any.
kalos::Vec3 ReadUp(vtkPolyData* luminaires, vtkIdType i, const kalos::Vec3& axis)
{
  const kalos::Vec3 given = ReadVector(luminaires, Names::Up, i, kalos::Frame(axis).s);
  const kalos::Vec3 across = given - kalos::dot(given, axis) * axis;
  if (!(kalos::length(across) > 1e-6 * kalos::length(given)))
    Refuse(Names::Up, "luminaire", i, "is along Direction, expected a direction across it");
  return kalos::normalized(across);
}

/// Without the zeros of a whole number.
std::string Shown(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}
}  // namespace

void AddLuminaires(vtkPolyData* input, kalos::SceneDescription& scene)
{
  if (input->GetNumberOfPoints() == 0)
    return;
  vtkKalosArrayLengths::Require(input->GetPointData(), input->GetNumberOfPoints(), "luminaires");
  Tables tables(input);
  auto* names = vtkStringArray::SafeDownCast(input->GetPointData()->GetAbstractArray(Names::LuminaireNames));
  vtkDataArray* flux = input->GetPointData()->GetArray(Names::LuminousFlux);
  vtkDataArray* distribution = input->GetPointData()->GetArray(Names::Distribution);
  if (!flux)
    throw std::invalid_argument("luminaires: the point array LuminousFlux is missing");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    kalos::Luminaire l;
    l.position = ToVec3(input->GetPoint(i));
    l.flux = flux->GetComponent(i, 0);
    if (!kalos::isFinite(l.position))
      Refuse("position", "luminaire", i, "must be finite");
    if (!(l.flux >= 0 && std::isfinite(l.flux)))
      Refuse(Names::LuminousFlux, "luminaire", i, "is " + std::to_string(l.flux) + ", expected lumens >= 0");
    const kalos::Vec3 axis = ReadVector(input, Names::Direction, i, {0, 0, -1});
    if (!(kalos::length(axis) > 0))
      Refuse(Names::Direction, "luminaire", i, "must not be zero");
    l.axis = kalos::normalized(axis);
    l.sideU = ReadVector(input, Names::SideU, i, {});
    l.sideV = ReadVector(input, Names::SideV, i, {});
    if (!l.isPoint() && !(kalos::length(kalos::cross(l.sideU, l.sideV)) > 0))
      Refuse(Names::SideV, "luminaire", i, "spans no area with SideU");
    const double number = distribution ? distribution->GetComponent(i, 0) : 1;
    if (!(number >= 0 && number <= largestDistribution && number == std::floor(number)))
      Refuse(Names::Distribution, "luminaire", i,
             "is " + Shown(number) + ", expected 0 (isotropic), 1 (Lambertian) or 2 and more (candela tables)");
    const int kind = static_cast<int>(number);
    l.distribution = kind == 0 && l.isPoint() ? kalos::Distribution::Isotropic : kalos::Distribution::Lambertian;
    if (kind >= 2)
    {
      l.distribution = kalos::Distribution::Measured;
      l.up = ReadUp(input, i, l.axis);
      l.table = tables.of(i, kind - 2);
    }
    scene.luminaires.push_back(l);
    scene.luminaireNames.push_back(names ? names->GetValue(i) : "");
  }
}
