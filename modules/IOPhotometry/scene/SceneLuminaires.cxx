// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLuminaires.h"

#include <algorithm>
#include <set>
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
int ReadDistribution(const JsonCursor& node)
{
  const std::string name = node.String();
  if (name != "isotropic" && name != "lambertian")
  {
    node.FailExpected("\"isotropic\" or \"lambertian\"");
  }
  return name == "isotropic" ? vtkKalosLuminaireSource::ISOTROPIC : vtkKalosLuminaireSource::LAMBERTIAN;
}

void ReadPoint(const JsonCursor& node, vtkKalosLuminaireSource* source)
{
  source->SetShape(vtkKalosLuminaireSource::POINT);
  source->SetPosition(node.At("position").Vector().data());
  source->SetDistribution(ReadDistribution(node.At("distribution")));
  const auto aim = node.Find("aim");
  if (aim)
  {
    source->SetAim(aim->NonZeroVector().data());
  }
  else if (source->GetDistribution() != vtkKalosLuminaireSource::ISOTROPIC)
  {
    node.Fail("the key \"aim\" is missing");
  }
}

void ReadRectangle(const JsonCursor& node, vtkKalosLuminaireSource* source)
{
  const JsonCursor rectangle = node.At("rectangle");
  rectangle.CheckKeys({"center", "u", "v"});
  source->SetShape(vtkKalosLuminaireSource::RECTANGLE);
  source->SetPosition(rectangle.At("center").Vector().data());
  source->SetSideU(rectangle.At("u").Vector().data());
  source->SetSideV(rectangle.At("v").Vector().data());
  source->SetAim(node.At("aim").NonZeroVector().data());
  const auto distribution = node.Find("distribution");
  if (distribution && ReadDistribution(*distribution) != vtkKalosLuminaireSource::LAMBERTIAN)
  {
    distribution->FailExpected("\"lambertian\", the only one of a rectangle");
  }
}

void AddWarning(vtkStringArray* warnings, const std::string& code, const std::string& file, const std::string& text)
{
  for (const std::string& part : {code, file, text})
  {
    warnings->InsertNextValue(part);
  }
}

/** A luminaire of a photometric file; each file's warnings are told once. */
vtkSmartPointer<vtkPolyData> ReadMeasured(const JsonCursor& node, const std::string& folder,
                                          std::set<std::string>& told, vtkStringArray* warnings, Notes& notes)
{
  node.CheckKeys({"name", "position", "aim", "rotation_deg", "flux", "file", "lamp_set"});
  const std::string path = ResolvePath(folder, node.At("file").String(), notes);
  vtkNew<vtkKalosPhotometryReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetName(node.Name());
  reader->SetPosition(node.At("position").Vector().data());
  reader->SetAim(node.At("aim").NonZeroVector().data());
  if (const auto rotation = node.Find("rotation_deg"))
  {
    reader->SetRotationDegrees(rotation->Number());
  }
  if (const auto flux = node.Find("flux"))
  {
    reader->SetFlux(flux->NumberAbove(0.0));
  }
  if (const auto lampSet = node.Find("lamp_set"))
  {
    reader->SetLampSet(lampSet->Integer(1, 20));
  }
  ErrorCatcher errors(reader, true);
  reader->Update();
  if (!errors.Empty())
  {
    const std::string text = errors.FirstLine();
    const std::size_t where = path.size() + 2, end = text.find(": ", where);
    throw InputError(path, text.substr(where, end - where), text.substr(end + 2));
  }
  for (int i = 0; i < reader->GetNumberOfWarnings() && told.count(path) == 0; ++i)
  {
    AddWarning(warnings, reader->GetWarningCode(i), path, reader->GetWarning(i));
  }
  told.insert(path);
  return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(3));
}

vtkSmartPointer<vtkPolyData> ReadLuminaire(const JsonCursor& node)
{
  node.CheckKeys({"name", "position", "rectangle", "aim", "rotation_deg", "flux", "distribution", "file", "lamp_set"});
  if (node.Has("position") == node.Has("rectangle"))
  {
    node.Fail("expected either \"position\" or \"rectangle\"");
  }
  vtkNew<vtkKalosLuminaireSource> source;
  source->SetName(node.Name());
  source->SetFlux(node.At("flux").NumberAtLeast(0.0));
  if (const auto rotation = node.Find("rotation_deg"))
  {
    source->SetRotationDegrees(rotation->Number());
  }
  node.Has("position") ? ReadPoint(node, source) : ReadRectangle(node, source);

  ErrorCatcher errors(source);
  source->Update();
  if (!errors.Empty())
  {
    const std::string text = errors.FirstLine();
    node.Fail(text.substr(text.find("': ") + 3));
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
  int Add(vtkPolyData* one)
  {
    auto* table =
        vtkDoubleArray::SafeDownCast(one->GetFieldData()->GetArray((vtkKalosArrayNames::CandelaTable + Zero).c_str()));
    const int pole = static_cast<int>(one->GetFieldData()->GetArray(vtkKalosArrayNames::CandelaPoles)->GetTuple1(0));
    for (std::size_t k = 0; k < this->All.size(); ++k)
    {
      if (this->Poles->GetValue(static_cast<vtkIdType>(k)) == pole && Equal(this->All[k], table))
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
  static bool Equal(vtkDoubleArray* a, vtkDoubleArray* b)
  {
    const vtkIdType count = a->GetNumberOfValues();
    return b->GetNumberOfValues() == count && std::equal(a->GetPointer(0), a->GetPointer(0) + count, b->GetPointer(0));
  }

  const std::string Zero = "0";
  vtkFieldData* Fields;
  vtkNew<vtkIntArray> Poles;
  std::vector<vtkSmartPointer<vtkDoubleArray>> All;
};

/** Add one luminaire to all. */
void Append(vtkPolyData* all, vtkPolyData* one, Tables& tables)
{
  vtkDataArray* distribution = one->GetPointData()->GetArray(vtkKalosArrayNames::Distribution);
  if (distribution->GetTuple1(0) == vtkKalosLuminaireSource::MEASURED)
  {
    distribution->SetTuple1(0, tables.Add(one));
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

vtkSmartPointer<vtkPolyData> ReadLuminaires(const JsonCursor& scene, const std::string& folder,
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
  const auto section = scene.Find("luminaires");
  for (const JsonCursor& node : section ? section->Items() : std::vector<JsonCursor>())
  {
    const auto one = node.Has("file") ? ReadMeasured(node, folder, told, warnings, notes) : ReadLuminaire(node);
    if (!names.insert(node.Name()).second)
    {
      node.Fail("another luminaire has this name; expected a name of its own");
    }
    Append(all, one, tables);
  }
  const std::set<std::string> own = names;
  for (ModelLight light : lights)
  {
    if (own.count(light.Name) == 0)
    {
      light.Name = FreeName(light.Name, "light", names);
      Append(all, MakeModelLuminaire(light, lit), tables);
    }
  }
  return all;
}
}  // namespace kalos::scene
