// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLuminaires.h"

#include <set>

#include "ErrorCatcher.h"
#include "vtkKalosLuminaireSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace kalos::scene
{
namespace
{
int ReadDistribution(const Node& node)
{
  const std::string name = node.String();
  if (name != "isotropic" && name != "lambertian")
  {
    node.FailExpected("\"isotropic\" or \"lambertian\"");
  }
  return name == "isotropic" ? vtkKalosLuminaireSource::ISOTROPIC : vtkKalosLuminaireSource::LAMBERTIAN;
}

void ReadPoint(const Node& node, vtkKalosLuminaireSource* source)
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

void ReadRectangle(const Node& node, vtkKalosLuminaireSource* source)
{
  const Node rectangle = node.At("rectangle");
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

vtkSmartPointer<vtkPolyData> ReadLuminaire(const Node& node)
{
  node.CheckKeys({"name", "position", "rectangle", "aim", "rotation_deg", "flux", "distribution", "file"});
  if (const auto file = node.Find("file"))
  {
    file->Fail("photometric files (.ies, .ldt) are not supported yet; expected \"flux\" and \"distribution\" instead");
  }
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
}  // namespace

vtkSmartPointer<vtkPolyData> ReadLuminaires(const Node& scene)
{
  auto all = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  all->SetPoints(points);
  all->AllocateExact(1, 1);
  std::set<std::string> names;
  const auto section = scene.Find("luminaires");
  for (const Node& node : section ? section->Items() : std::vector<Node>())
  {
    const auto one = ReadLuminaire(node);
    if (!names.insert(node.Name()).second)
    {
      node.Fail("another luminaire has this name; expected a name of its own");
    }
    const vtkIdType id = points->InsertNextPoint(one->GetPoint(0));
    all->InsertNextCell(VTK_VERTEX, 1, &id);
    if (id == 0)
    {
      all->GetPointData()->DeepCopy(one->GetPointData());
      continue;
    }
    for (int a = 0; a < all->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = all->GetPointData()->GetAbstractArray(a);
      array->InsertNextTuple(0, one->GetPointData()->GetAbstractArray(array->GetName()));
    }
  }
  return all;
}
}  // namespace kalos::scene
