// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosLuminanceImage.h"

#include <algorithm>
#include <exception>

#include "CheckpointFile.h"
#include "ControllerRanks.h"
#include "ErrorCodes.h"
#include "estimator/quantities/LuminanceImage.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkKalosLuminanceImage);

vtkKalosLuminanceImage::vtkKalosLuminanceImage()
{
  this->SetNumberOfInputPorts(2);
}

int vtkKalosLuminanceImage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkKalosLuminanceImage::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkKalosLuminanceImage::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (!vtkImageData::GetData(outputs))
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), vtkSmartPointer<vtkImageData>::New());
  return 1;
}

int vtkKalosLuminanceImage::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const int extent[6] = {0, this->Resolution[0] - 1, 0, this->Resolution[1] - 1, 0, 0};
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

namespace
{
kalos::Vec3 ToVec3(const double v[3])
{
  return {v[0], v[1], v[2]};
}

template <class Array, class Value>
void AddPixels(vtkImageData* image, const char* name, const std::vector<Value>& values, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  image->GetPointData()->AddArray(array);
}

void FillImage(vtkImageData* image, const int resolution[2], const kalos::LuminanceResult& result)
{
  image->SetDimensions(resolution[0], resolution[1], 1);
  AddPixels<vtkDoubleArray>(image, vtkKalosArrayNames::Luminance, result.luminance);
  AddPixels<vtkDoubleArray>(image, vtkKalosArrayNames::LuminanceStandardError, result.standardError);
  AddPixels<vtkUnsignedCharArray>(image, vtkKalosArrayNames::IntervalTrusted, result.trusted);
  if (result.bands > 1)
    AddPixels<vtkDoubleArray>(image, vtkKalosArrayNames::LuminanceBands, result.luminanceBands, result.bands);
  image->GetPointData()->SetActiveScalars(vtkKalosArrayNames::Luminance);
}
}  // namespace

int vtkKalosLuminanceImage::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    const auto scene = this->MakeScene(vtkPolyData::GetData(inputs[0]), vtkPolyData::GetData(inputs[1]));
    const kalos::Camera camera{ToVec3(this->Position), ToVec3(this->Target), ToVec3(this->Up),  this->FieldOfView,
                               this->Resolution[0],    this->Resolution[1],  this->PixelSamples};
    const ControllerRanks ranks(this->Controller);
    const auto checkpoint = this->MakeCheckpoint();
    kalos::ImageSnapshot show;
    if (this->IntermediateResults)
      show = [&](const kalos::LuminanceResult& soFar) {
        vtkNew<vtkImageData> image;
        FillImage(image, this->Resolution, soFar);
        this->Describe(soFar.estimate, image->GetFieldData());
        this->InvokeEvent(vtkCommand::UpdateDataEvent, image.Get());
      };
    kalos::LuminanceResult result = kalos::solveLuminance(
        *scene, camera, this->MakeSettings(ranks, checkpoint.get()),
        [this](double f) { return this->ReportProgress(f); }, show);
    if (result.estimate.trajectories == 0)  // stopped before the first round was complete
      return 1;
    if (std::all_of(result.luminance.begin(), result.luminance.end(), [](double l) { return l <= 0; }))
      result.estimate.audit.push_back(
          {"warning", "the image is black",
           "nothing lit is in sight of the camera: inside a solid, outside of a closed room "
           "or turned away from it"});
    FillImage(output, this->Resolution, result);
    this->Describe(result.estimate, output->GetFieldData());
    this->Tell(result.estimate);
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* asked = outputs->GetInformationObject(0);
    if (asked->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) && asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
      output->Crop(asked->Get(Pipeline::UPDATE_EXTENT()));
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

void vtkKalosLuminanceImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto print = [&](const char* name, const double v[3]) {
    os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n";
  };
  print("Position", this->Position);
  print("Target", this->Target);
  print("Up", this->Up);
  os << indent << "FieldOfView: " << this->FieldOfView << "\n";
  os << indent << "Resolution: " << this->Resolution[0] << " " << this->Resolution[1] << "\n";
  os << indent << "PixelSamples: " << this->PixelSamples << "\n";
}
