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
void setRoundBeam(vtkKalosLuminaireSource* source, const std::vector<double>& angles,
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

void makeSpot(const ModelLight& light, vtkKalosLuminaireSource* source)
{
  // As the extension writes it: the difference of the cosines is at least 0.001.
  const double outer = std::cos(light.outerAngle), inner = std::max(std::cos(light.innerAngle), outer + 0.001);
  const double innerAngle = std::acos(std::min(1.0, inner));
  std::vector<double> angles, candela;
  if (innerAngle > 0.0)
  {
    angles.push_back(0.0);
    candela.push_back(light.strength);
  }
  for (int i = 0; i <= SpotSteps; ++i)
  {
    const double angle = innerAngle + (light.outerAngle - innerAngle) * i / SpotSteps;
    const double share = std::clamp((std::cos(angle) - outer) / (inner - outer), 0.0, 1.0);
    angles.push_back(std::min(180.0, angle * 180.0 / Pi));
    candela.push_back(light.strength * share * share);
  }
  setRoundBeam(source, angles, candela);
}

void makeParallel(const ModelLight& light, const Ball& scene, vtkKalosLuminaireSource* source)
{
  const double distance = ParallelDistance * scene.radius;
  const double edge = std::asin(1.0 / ParallelDistance) * 180.0 / Pi;
  const double intensity = light.strength * distance * distance;
  source->SetPosition((scene.center - distance * light.aim).data());
  setRoundBeam(source, {0.0, edge}, {intensity, intensity});
}
}  // namespace

vtkSmartPointer<vtkPolyData> makeModelLuminaire(const ModelLight& light, const Ball& scene)
{
  vtkNew<vtkKalosLuminaireSource> source;
  source->SetName(light.name);
  source->SetPosition(light.position.data());
  source->SetAim(light.aim.data());
  if (!(light.strength > 0.0) || light.type == ModelLight::Kind::Point)
  {
    source->SetDistribution(vtkKalosLuminaireSource::ISOTROPIC);
    source->SetFlux(4.0 * Pi * light.strength);
  }
  else if (light.type == ModelLight::Kind::Spot)
  {
    makeSpot(light, source);
  }
  else
  {
    makeParallel(light, scene, source);
  }
  source->Update();
  return source->GetOutput();
}
}  // namespace kalos::scene
