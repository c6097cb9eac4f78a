// SPDX-License-Identifier: BSD-3-Clause
#include "run/RunPlan.h"

#include <algorithm>

#include "base/DataSets.h"
#include "run/Preview.h"
#include "vtkDataSet.h"
#include "vtkKalosIlluminance.h"
#include "vtkKalosLuminanceImage.h"

namespace studio
{
namespace
{
constexpr qint64 quickTrajectories = 32;
constexpr vtkIdType fewReceivers = 64;

/// The thread of a run must not share lazily built data with the window.
template <class Data>
vtkSmartPointer<Data> copyOf(Data* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

vtkIdType countOf(vtkDataObject* receivers)
{
  vtkIdType count = 0;
  for (const NamedSet& set : dataSets(receivers))
    count += std::max(set.data->GetNumberOfPoints(), set.data->GetNumberOfCells());
  return count;
}

MethodSettings quick(MethodSettings settings)
{
  settings.goal = Goal::Trajectories;
  settings.trajectories = quickTrajectories;
  return settings;
}
}  // namespace

RunPlan planReceivers(const SceneDocument& scene, vtkDataObject* receivers, const MethodSettings& settings,
                      bool previews)
{
  auto illuminance = vtkSmartPointer<vtkKalosIlluminance>::New();
  illuminance->TellWarningsOff();  // the panel of the audit shows them
  const auto all = copyOf(receivers);
  illuminance->SetKeepReplicates(countOf(all) <= fewReceivers);
  illuminance->SetInputData(1, copyOf(scene.surfaces()));
  illuminance->SetInputData(2, copyOf(scene.luminaires()));
  return {illuminance, [=] {
            std::vector<RunStep> steps;
            for (int wanted : {1200, 6000, 30000})
              if (const auto some = previews ? someReceivers(all, wanted) : nullptr)
                steps.push_back({quick(settings), [=] { illuminance->SetInputDataObject(0, some); },
                                 [some, all, spread = std::shared_ptr<Spread>()](vtkDataObject* solved) mutable {
                                   if (!spread)
                                     spread = std::make_shared<Spread>(some, all);
                                   return spread->over(solved);
                                 }});
            steps.push_back({settings, [=] { illuminance->SetInputDataObject(0, all); }, {}});
            return steps;
          }};
}

RunPlan planImage(const SceneDocument& scene, const CameraPreset& camera, int width, int height,
                  const MethodSettings& settings)
{
  auto image = vtkSmartPointer<vtkKalosLuminanceImage>::New();
  image->TellWarningsOff();
  image->SetInputData(0, copyOf(scene.surfaces()));
  image->SetInputData(1, copyOf(scene.luminaires()));
  image->SetPosition(camera.position.GetData());
  image->SetTarget(camera.target.GetData());
  image->SetUp(camera.up.GetData());
  image->SetFieldOfView(camera.verticalAngle(static_cast<double>(width) / height));
  return {image, [=] {
            std::vector<RunStep> steps;
            for (int part : {8, 4, 2, 1})
              if (part == 1 || height / part >= 16)
                steps.push_back({part == 1 ? settings : quick(settings),
                                 [=] { image->SetResolution(std::max(1, width / part), std::max(1, height / part)); },
                                 {}});
            return steps;
          }};
}
}  // namespace studio
