// SPDX-License-Identifier: BSD-3-Clause
#include "ModelLuminaire.h"

#include <algorithm>
#include <cmath>

#include "photometry/CandelaTable.h"
#include "vtkDoubleArray.h"
#include "vtkKalosLuminaireSource.h"
#include "vtkNew.h"

namespace kalos::scene
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/** A table that is the same in all half-planes: intensities at angles from the aim, both in degrees. */
void SetRoundBeam(vtkKalosLuminaireSource* source, const std::vector<double>& angles,
                  const std::vector<double>& candela)
{
  vtkNew<vtkDoubleArray> tuples;
  tuples->SetNumberOfComponents(3);
  std::vector<double> twice;
  for (const double plane : {0.0, 360.0})
  {
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      tuples->InsertNextTuple3(plane, angles[i], candela[i]);
      twice.push_back(candela[i]);
    }
  }
  source->SetCandelaTable(tuples, false);
  source->SetFlux(CandelaTable({0.0, 360.0}, angles, twice, CandelaTable::Pole::Axis).flux());
}

void MakeSpot(const ModelLight& light, vtkKalosLuminaireSource* source)
{
  const double inner = std::cos(light.InnerAngle), outer = std::cos(light.OuterAngle);
  std::vector<double> angles, candela;
  if (light.InnerAngle > 0.0)
  {
    angles.push_back(0.0);
    candela.push_back(light.Strength);
  }
  for (int i = 0; i <= SpotSteps; ++i)
  {
    const double angle = light.InnerAngle + (light.OuterAngle - light.InnerAngle) * i / SpotSteps;
    // As the extension writes it: the difference of the cosines is at least 0.001.
    const double share = std::clamp((std::cos(angle) - outer) / std::max(0.001, inner - outer), 0.0, 1.0);
    angles.push_back(std::min(180.0, angle * 180.0 / Pi));
    candela.push_back(light.Strength * share * share);
  }
  SetRoundBeam(source, angles, candela);
}

void MakeParallel(const ModelLight& light, const Ball& scene, vtkKalosLuminaireSource* source)
{
  const double distance = ParallelDistance * scene.Radius;
  const double edge = std::asin(1.0 / ParallelDistance) * 180.0 / Pi;
  const double intensity = light.Strength * distance * distance;
  source->SetPosition((scene.Center - distance * light.Aim).data());
  SetRoundBeam(source, {0.0, edge}, {intensity, intensity});
}
}  // namespace

vtkSmartPointer<vtkPolyData> MakeModelLuminaire(const ModelLight& light, const Ball& scene)
{
  vtkNew<vtkKalosLuminaireSource> source;
  source->SetName(light.Name);
  source->SetPosition(light.Position.data());
  source->SetAim(light.Aim.data());
  if (!(light.Strength > 0.0) || light.Type == ModelLight::Kind::Point)
  {
    source->SetDistribution(vtkKalosLuminaireSource::ISOTROPIC);
    source->SetFlux(4.0 * Pi * light.Strength);
  }
  else if (light.Type == ModelLight::Kind::Spot)
  {
    MakeSpot(light, source);
  }
  else
  {
    MakeParallel(light, scene, source);
  }
  source->Update();
  return source->GetOutput();
}
}  // namespace kalos::scene
