// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLuminaires.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../base/ErrorCatcher.h"
#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/Names.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosLuminaireSource.h"
#include "vtkKalosPhotometryReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

namespace kalos::scene
{
namespace
{
int readDistribution(const JsonCursor& node)
{
  const std::string name = node.string();
  if (name != "isotropic" && name != "lambertian")
  {
    node.failExpected("\"isotropic\" or \"lambertian\"");
  }
  return name == "isotropic" ? vtkKalosLuminaireSource::ISOTROPIC : vtkKalosLuminaireSource::LAMBERTIAN;
}

void readPoint(const JsonCursor& node, vtkKalosLuminaireSource* source)
{
  source->SetShape(vtkKalosLuminaireSource::POINT);
  source->SetPosition(node.at("position").vector().data());
  source->SetDistribution(readDistribution(node.at("distribution")));
  const auto aim = node.find("aim");
  if (aim)
  {
    source->SetAim(aim->nonZeroVector().data());
  }
  else if (source->GetDistribution() != vtkKalosLuminaireSource::ISOTROPIC)
  {
    node.fail("the key \"aim\" is missing");
  }
}

void readRectangle(const JsonCursor& node, vtkKalosLuminaireSource* source)
{
  const JsonCursor rectangle = node.at("rectangle");
  rectangle.checkKeys({"center", "u", "v"});
  source->SetShape(vtkKalosLuminaireSource::RECTANGLE);
  source->SetPosition(rectangle.at("center").vector().data());
  source->SetSideU(rectangle.at("u").vector().data());
  source->SetSideV(rectangle.at("v").vector().data());
  source->SetAim(node.at("aim").nonZeroVector().data());
  const auto distribution = node.find("distribution");
  if (distribution && readDistribution(*distribution) != vtkKalosLuminaireSource::LAMBERTIAN)
  {
    distribution->failExpected("\"lambertian\", the only one of a rectangle");
  }
}

void addWarning(vtkStringArray* warnings, const std::string& code, const std::string& file, const std::string& text)
{
  for (const std::string& part : {code, file, text})
  {
    warnings->InsertNextValue(part);
  }
}

/** A luminaire of a photometric file; each file's warnings are told once. */
vtkSmartPointer<vtkPolyData> readMeasured(const JsonCursor& node, const std::string& folder,
                                          std::set<std::string>& told, vtkStringArray* warnings, Notes& notes)
{
  node.checkKeys({"name", "position", "aim", "rotation_deg", "flux", "file", "lamp_set", "maintenance_factor"});
  const std::string path = resolvePath(folder, node.at("file").string(), notes);
  vtkNew<vtkKalosPhotometryReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetName(node.name());
  reader->SetPosition(node.at("position").vector().data());
  reader->SetAim(node.at("aim").nonZeroVector().data());
  if (const auto rotation = node.find("rotation_deg"))
  {
    reader->SetRotationDegrees(rotation->number());
  }
  if (const auto flux = node.find("flux"))
  {
    reader->SetFlux(flux->numberAbove(0.0));
  }
  if (const auto lampSet = node.find("lamp_set"))
  {
    reader->SetLampSet(lampSet->integer(1, 20));
  }
  ErrorCatcher errors(reader, true);
  reader->Update();
  if (!errors.empty())
  {
    const std::string text = errors.firstLine();
    const std::size_t where = path.size() + 2, end = text.find(": ", where);
    throw InputError(path, text.substr(where, end - where), text.substr(end + 2));
  }
  for (int i = 0; i < reader->GetNumberOfWarnings() && told.count(path) == 0; ++i)
  {
    addWarning(warnings, reader->GetWarningCode(i), path, reader->GetWarning(i));
  }
  told.insert(path);
  return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(3));
}

vtkSmartPointer<vtkPolyData> readLuminaire(const JsonCursor& node)
{
  node.checkKeys({"name", "position", "rectangle", "aim", "rotation_deg", "flux", "distribution", "file", "lamp_set",
                  "maintenance_factor"});
  if (node.has("position") == node.has("rectangle"))
  {
    node.fail("expected either \"position\" or \"rectangle\"");
  }
  vtkNew<vtkKalosLuminaireSource> source;
  source->SetName(node.name());
  source->SetFlux(node.at("flux").numberAtLeast(0.0));
  if (const auto rotation = node.find("rotation_deg"))
  {
    source->SetRotationDegrees(rotation->number());
  }
  node.has("position") ? readPoint(node, source) : readRectangle(node, source);

  ErrorCatcher errors(source);
  source->Update();
  if (!errors.empty())
  {
    const std::string text = errors.firstLine();
    node.fail(text.substr(text.find("': ") + 3));
  }
  return source->GetOutput();
}

/** Candela tables of all luminaires; equal ones are kept once. */
class Tables
{
public:
  explicit Tables(vtkPolyData* luminaires) : Fields(luminaires->GetFieldData())
  {
    this->Poles->SetName(vtkKalosArrayNames::CandelaPoles);
  }

  /** The Distribution of a luminaire in the common numbering. */
  int add(vtkPolyData* one)
  {
    auto* table =
        vtkDoubleArray::SafeDownCast(one->GetFieldData()->GetArray((vtkKalosArrayNames::CandelaTable + Zero).c_str()));
    const int pole = static_cast<int>(one->GetFieldData()->GetArray(vtkKalosArrayNames::CandelaPoles)->GetTuple1(0));
    for (std::size_t k = 0; k < this->All.size(); ++k)
    {
      if (this->Poles->GetValue(static_cast<vtkIdType>(k)) == pole && equal(this->All[k], table))
      {
        return 2 + static_cast<int>(k);
      }
    }
    if (this->All.empty())
    {
      this->Fields->AddArray(this->Poles);
    }
    table->SetName((vtkKalosArrayNames::CandelaTable + std::to_string(this->All.size())).c_str());
    this->Fields->AddArray(table);
    this->Poles->InsertNextValue(pole);
    this->All.push_back(table);
    return 1 + static_cast<int>(this->All.size());
  }

private:
  static bool equal(vtkDoubleArray* a, vtkDoubleArray* b)
  {
    const vtkIdType count = a->GetNumberOfValues();
    return b->GetNumberOfValues() == count && std::equal(a->GetPointer(0), a->GetPointer(0) + count, b->GetPointer(0));
  }

  const std::string Zero = "0";
  vtkFieldData* Fields;
  vtkNew<vtkIntArray> Poles;
  std::vector<vtkSmartPointer<vtkDoubleArray>> All;
};

/** How much of the flux of new luminaires is left: of the scene, or of a luminaire of its own. */
class Maintenance
{
public:
  explicit Maintenance(const JsonCursor& scene) : Usual(factorOf(scene).value_or(1.0)) {}

  void apply(const std::optional<double>& own, vtkPolyData* luminaire)
  {
    const double factor = own.value_or(this->Usual);
    vtkDataArray* flux = luminaire->GetPointData()->GetArray(vtkKalosArrayNames::LuminousFlux);
    flux->SetTuple1(0, factor * flux->GetTuple1(0));
    ++this->Luminaires[factor];
  }

  static std::optional<double> factorOf(const JsonCursor& node)
  {
    const auto factor = node.find("maintenance_factor");
    return factor ? std::optional<double>(factor->share()) : std::nullopt;
  }

  /** A note where any factor is not 1. */
  void tell(Notes& notes) const
  {
    std::ostringstream choice;
    for (const auto& [factor, count] : this->Luminaires)
    {
      choice << (choice.tellp() > 0 ? ", " : "") << factor << " of the flux of " << count;
    }
    if (this->Luminaires.size() > 1 || (!this->Luminaires.empty() && this->Luminaires.begin()->first != 1.0))
    {
      notes.push_back({"maintenance factor", choice.str() + " luminaires",
                       "every value is maintained; emission of surfaces is taken as it is given"});
    }
  }

private:
  double Usual;
  std::map<double, int> Luminaires;
};

/** Add one luminaire to all. */
void append(vtkPolyData* all, vtkPolyData* one, Tables& tables)
{
  vtkDataArray* distribution = one->GetPointData()->GetArray(vtkKalosArrayNames::Distribution);
  if (distribution->GetTuple1(0) == vtkKalosLuminaireSource::MEASURED)
  {
    distribution->SetTuple1(0, tables.add(one));
  }
  const vtkIdType id = all->GetPoints()->InsertNextPoint(one->GetPoint(0));
  all->InsertNextCell(VTK_VERTEX, 1, &id);
  if (id == 0)
  {
    all->GetPointData()->DeepCopy(one->GetPointData());
    return;
  }
  for (int a = 0; a < all->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = all->GetPointData()->GetAbstractArray(a);
    array->InsertNextTuple(0, one->GetPointData()->GetAbstractArray(array->GetName()));
  }
}
}  // namespace

vtkSmartPointer<vtkPolyData> readLuminaires(const JsonCursor& scene, const std::string& folder,
                                            const std::vector<ModelLight>& lights, const Ball& lit, Notes& notes)
{
  auto all = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  all->SetPoints(points);
  all->AllocateExact(1, 1);
  std::set<std::string> names;
  std::set<std::string> told;
  vtkNew<vtkStringArray> warnings;
  warnings->SetName(vtkKalosArrayNames::PhotometryWarnings);
  warnings->SetNumberOfComponents(3);
  all->GetFieldData()->AddArray(warnings);
  Tables tables(all);
  Maintenance maintenance(scene);
  const auto section = scene.find("luminaires");
  for (const JsonCursor& node : section ? section->items() : std::vector<JsonCursor>())
  {
    const auto one = node.has("file") ? readMeasured(node, folder, told, warnings, notes) : readLuminaire(node);
    if (!names.insert(node.name()).second)
    {
      node.fail("another luminaire has this name; expected a name of its own");
    }
    maintenance.apply(Maintenance::factorOf(node), one);
    append(all, one, tables);
  }
  const std::set<std::string> own = names;
  for (ModelLight light : lights)
  {
    if (own.count(light.name) == 0)
    {
      light.name = freeName(light.name, "light", names);
      const auto one = makeModelLuminaire(light, lit);
      maintenance.apply({}, one);
      append(all, one, tables);
    }
  }
  maintenance.tell(notes);
  return all;
}
}  // namespace kalos::scene
