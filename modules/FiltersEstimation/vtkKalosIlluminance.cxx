// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosIlluminance.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "CheckpointFile.h"
#include "ControllerRanks.h"
#include "ErrorCodes.h"
#include "ReceiverConversion.h"
#include "estimator/quantities/DarkReceivers.h"
#include "estimator/quantities/LostLuminaires.h"
#include "estimator/solve/Replay.h"
#include "estimator/solve/Solver.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkKalosIlluminance);

vtkKalosIlluminance::vtkKalosIlluminance()
{
  this->SetNumberOfInputPorts(3);
}

int vtkKalosIlluminance::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    // The composite type comes first: all blocks are solved together, not one by one.
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 2)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkKalosIlluminance::RequestDataObject(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  if (!input)
    return 0;
  if (!output || !output->IsA(input->GetClassName()))
  {
    auto fresh = vtk::TakeSmartPointer(input->NewInstance());
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return 1;
}

namespace
{
/// A copy that shares the arrays but not the data sets, so that results can be attached to it.
vtkSmartPointer<vtkDataObject> CopyWithOwnLeaves(vtkDataObject* input)
{
  auto copy = vtk::TakeSmartPointer(input->NewInstance());
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input);
  if (!blocks)
  {
    copy->ShallowCopy(input);
    return copy;
  }
  auto* copiedBlocks = vtkMultiBlockDataSet::SafeDownCast(copy);
  copiedBlocks->CopyStructure(blocks);
  auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    copiedBlocks->SetDataSet(iterator, CopyWithOwnLeaves(iterator->GetCurrentDataObject()));
  return copy;
}
}  // namespace

namespace
{
vtkSmartPointer<vtkDoubleArray> ReplayTable(const kalos::Replay& replay)
{
  vtkNew<vtkDoubleArray> table;
  table->SetName(vtkKalosArrayNames::Replay);
  table->SetNumberOfComponents(5);
  for (const kalos::RoundScores& r : replay.rounds)
    table->InsertNextTuple(
        std::array<double, 5>{static_cast<double>(r.first), static_cast<double>(r.count), r.sum, r.direct, r.largest}
            .data());
  table->InsertNextTuple(std::array<double, 5>{static_cast<double>(replay.replicates),
                                               static_cast<double>(replay.trajectories), replay.estimate, replay.fixed,
                                               0}
                             .data());
  return table;
}
}  // namespace

vtkSmartPointer<vtkDataObject> vtkKalosIlluminance::MakeOutput(vtkDataObject* receivers, const kalos::Result& result,
                                                               const std::vector<char>& valid) const
{
  vtkSmartPointer<vtkDataObject> dressed = CopyWithOwnLeaves(receivers);
  std::size_t next = 0;
  for (vtkDataSet* leaf : LeavesOf(dressed))
  {
    next = AttachResults(result, valid, next, leaf);
    this->Describe(result, leaf->GetFieldData());
  }
  this->Describe(result, dressed->GetFieldData());
  return dressed;
}

int vtkKalosIlluminance::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
    const auto scene = this->MakeScene(vtkPolyData::GetData(inputs[1]), vtkPolyData::GetData(inputs[2]));
    kalos::Receivers receivers;
    for (vtkDataSet* leaf : LeavesOf(input))
      AppendReceivers(leaf, receivers);

    if (this->ReplayReceiver >= 0)
    {
      const kalos::Ranks alone;
      const kalos::Replay replay = kalos::replay(*scene, receivers, this->MakeSettings(alone, nullptr),
                                                 static_cast<std::size_t>(this->ReplayReceiver), this->ReplayReplicate);
      output->Initialize();
      output->GetFieldData()->AddArray(ReplayTable(replay));
      return 1;
    }
    kalos::Snapshot show;
    const std::vector<char> allValid(receivers.points.size(), 1);  // until the end, when dark receivers are examined
    if (this->IntermediateResults)
      show = [&](const kalos::Result& soFar) {
        this->InvokeEvent(vtkCommand::UpdateDataEvent, this->MakeOutput(input, soFar, allValid).Get());
      };
    const ControllerRanks ranks(this->Controller);
    const auto checkpoint = this->MakeCheckpoint();
    kalos::Settings settings = this->MakeSettings(ranks, checkpoint.get());
    settings.keepReplicates = this->KeepReplicates;
    kalos::Result result = kalos::solve(
        *scene, receivers, settings, [this](double f) { return this->ReportProgress(f); }, show);
    if (result.trajectories == 0)  // stopped before the first round was complete
      return 1;
    kalos::DarkReceivers dark = kalos::findDarkReceivers(*scene, receivers, result);
    for (const std::vector<kalos::AuditLine>& lines :
         {dark.audit, kalos::findLostLuminaires(*scene, receivers, dark.valid)})
      result.audit.insert(result.audit.end(), lines.begin(), lines.end());
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* asked = outputs->GetInformationObject(0);
    if (asked->Has(Pipeline::UPDATE_PIECE_NUMBER()) && asked->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
    {
      output->Initialize();  // piece 0 holds everything
      return 1;
    }
    output->ShallowCopy(this->MakeOutput(input, result, dark.valid));
    this->Tell(result);
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(ErrorCodeOf(error));
    vtkErrorMacro(<< error.what());
    output->Initialize();
    return 0;
  }
  return 1;
}

void vtkKalosIlluminance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReplayReceiver: " << this->ReplayReceiver << "\n";
  os << indent << "ReplayReplicate: " << this->ReplayReplicate << "\n";
  os << indent << "KeepReplicates: " << (this->KeepReplicates ? "on" : "off") << "\n";
}
