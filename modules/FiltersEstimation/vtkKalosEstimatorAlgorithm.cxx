// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosEstimatorAlgorithm.h"

#include "CheckpointFile.h"
#include "SceneConversion.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

vtkCxxSetObjectMacro(vtkKalosEstimatorAlgorithm, Controller, vtkMultiProcessController);

struct vtkKalosEstimatorAlgorithm::KeptScene
{
  vtkMTimeType Surfaces, Luminaires;  // no two objects ever have the same time
  std::shared_ptr<const kalos::Scene> Scene;
};

vtkKalosEstimatorAlgorithm::vtkKalosEstimatorAlgorithm()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkKalosEstimatorAlgorithm::~vtkKalosEstimatorAlgorithm()
{
  this->SetController(nullptr);
  this->SetDisabledTechniques(nullptr);
  this->SetCheckpointFile(nullptr);
}

int vtkKalosEstimatorAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                    vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      if (input->Has(Pipeline::WHOLE_EXTENT()))
        input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  return 1;
}

std::unique_ptr<kalos::CheckpointStore> vtkKalosEstimatorAlgorithm::MakeCheckpoint()
{
  if (!this->CheckpointFile || !*this->CheckpointFile)
    return nullptr;
  return std::make_unique<::CheckpointFile>(this->CheckpointFile, this->CheckpointInterval,
                                            [this](const std::string& why) { vtkWarningMacro(<< why); });
}

std::shared_ptr<const kalos::Scene> vtkKalosEstimatorAlgorithm::MakeScene(vtkPolyData* surfaces,
                                                                          vtkPolyData* luminaires)
{
  const vtkMTimeType surfacesTime = surfaces->GetMTime(), luminairesTime = luminaires ? luminaires->GetMTime() : 0;
  if (this->Kept && this->Kept->Surfaces == surfacesTime && this->Kept->Luminaires == luminairesTime)
    return this->Kept->Scene;
  this->Kept = nullptr;
  auto scene = std::make_shared<const kalos::Scene>(MakeSceneDescription(surfaces, luminaires));
  if (this->KeepScene)
    this->Kept = std::make_unique<KeptScene>(KeptScene{surfacesTime, luminairesTime, scene});
  return scene;
}

kalos::Settings vtkKalosEstimatorAlgorithm::MakeSettings(const kalos::Ranks& ranks,
                                                         kalos::CheckpointStore* checkpoint) const
{
  kalos::Settings settings;
  settings.ranks = &ranks;
  settings.checkpoint = checkpoint;
  settings.method = static_cast<kalos::Method>(this->Method);
  settings.trajectories = this->Trajectories;
  settings.relativeError = this->RelativeError;
  settings.errorFloor = this->ErrorFloor;
  settings.seconds = this->Seconds;
  settings.seed = static_cast<std::uint64_t>(this->Seed);
  settings.threads = this->Threads;
  settings.delta = this->Delta;
  settings.epsilon = this->Epsilon;
  settings.own.photons = this->Photons;
  settings.own.coneFilter = this->ConeFilter;
  settings.own.finalGather = this->FinalGather;
  if (this->DisabledTechniques)
    settings.disabled = kalos::TechniqueSet::named(this->DisabledTechniques);
  return settings;
}

bool vtkKalosEstimatorAlgorithm::ReportProgress(double fraction)
{
  this->UpdateProgress(fraction);
  return !this->GetAbortExecute();
}

namespace
{
template <class Array, class Value>
void AddValue(vtkFieldData* fieldData, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fieldData->AddArray(array);
}
}  // namespace

void vtkKalosEstimatorAlgorithm::Describe(const kalos::Result& result, vtkFieldData* fieldData) const
{
  vtkNew<vtkStringArray> audit;
  audit->SetName(vtkKalosArrayNames::Audit);
  audit->SetNumberOfComponents(3);
  for (const auto& line : result.audit)
  {
    audit->InsertNextValue(line.subject);
    audit->InsertNextValue(line.choice);
    audit->InsertNextValue(line.reason);
  }
  fieldData->AddArray(audit);
  AddValue<vtkIdTypeArray>(fieldData, vtkKalosArrayNames::Trajectories, static_cast<vtkIdType>(result.trajectories));
  AddValue<vtkIdTypeArray>(fieldData, vtkKalosArrayNames::Rays, static_cast<vtkIdType>(result.rays));
  AddValue<vtkDoubleArray>(fieldData, vtkKalosArrayNames::SolveSeconds, result.seconds);
  AddValue<vtkDoubleArray>(fieldData, vtkKalosArrayNames::SolveCpuSeconds, result.cpuSeconds);
  AddValue<vtkIdTypeArray>(fieldData, vtkKalosArrayNames::Seed, this->Seed);
  AddValue<vtkStringArray>(fieldData, vtkKalosArrayNames::KalosVersion, kalos::version());
}

void vtkKalosEstimatorAlgorithm::Tell(const kalos::Result& result)
{
  for (const auto& line : result.audit)
    if (this->TellWarnings && line.subject == "warning")
      vtkWarningMacro(<< line.choice << ": " << line.reason);
}

void vtkKalosEstimatorAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Trajectories: " << this->Trajectories << "\n";
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "ErrorFloor: " << this->ErrorFloor << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "Delta: " << this->Delta << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "Photons: " << this->Photons << "\n";
  os << indent << "ConeFilter: " << (this->ConeFilter ? "on" : "off") << "\n";
  os << indent << "FinalGather: " << (this->FinalGather ? "on" : "off") << "\n";
  os << indent << "CheckpointFile: " << (this->CheckpointFile ? this->CheckpointFile : "(none)") << "\n";
  os << indent << "CheckpointInterval: " << this->CheckpointInterval << "\n";
  os << indent << "TellWarnings: " << (this->TellWarnings ? "on" : "off") << "\n";
  os << indent << "KeepScene: " << (this->KeepScene ? "on" : "off") << "\n";
  os << indent << "IntermediateResults: " << (this->IntermediateResults ? "on" : "off") << "\n";
  os << indent << "DisabledTechniques: " << (this->DisabledTechniques ? this->DisabledTechniques : "") << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
