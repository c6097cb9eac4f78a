// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosGlareRating.h"

#include <cmath>
#include <stdexcept>

#include "ErrorCodes.h"
#include "SceneConversion.h"
#include "SurfaceJoining.h"
#include "estimator/quantities/GlareRating.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkKalosGlareRating);

vtkKalosGlareRating::vtkKalosGlareRating()
{
  this->SetNumberOfInputPorts(3);
}

int vtkKalosGlareRating::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
    return AcceptAnyData(info);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 2)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

namespace
{
namespace Names = vtkKalosArrayNames;

vtkDataArray* Require(vtkPolyData* observers, const char* name)
{
  vtkDataArray* array = observers->GetPointData()->GetArray(name);
  if (!array)
    throw std::invalid_argument(std::string("observers: the point array ") + name +
                                " is missing, expected observers that vtkKalosIlluminance has put out");
  return array;
}

kalos::Vec3 Vector(vtkDataArray* array, vtkIdType i)
{
  const double* v = array->GetTuple3(i);
  return {v[0], v[1], v[2]};
}

kalos::Observer ReadObserver(vtkPolyData* observers, vtkDataArray* normals, vtkDataArray* ups, vtkIdType i)
{
  const double* at = observers->GetPoint(i);
  kalos::Observer observer;
  observer.position = {at[0], at[1], at[2]};
  observer.sight = kalos::normalized(Vector(normals, i));
  if (ups)
    observer.up = Vector(ups, i);
  const double across = kalos::length(kalos::cross(observer.sight, observer.up));
  if (!(across > 1e-9 * kalos::length(observer.up)))
    throw std::invalid_argument("observers: " + std::to_string(i) +
                                " looks along ObserverUp, expected an up direction across the line of sight");
  return observer;
}

vtkSmartPointer<vtkDoubleArray> AddColumn(vtkPolyData* data, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

void Rate(vtkPolyData* observers, const kalos::Scene& scene)
{
  vtkDataArray* normals = observers->GetPointData()->GetNormals();
  if (!normals)
    throw std::invalid_argument("observers: have no point normals, expected lines of sight");
  vtkDataArray* ups = observers->GetPointData()->GetArray(Names::ObserverUp);
  vtkDataArray* total = Require(observers, Names::Illuminance);
  vtkDataArray* direct = Require(observers, Names::DirectIlluminance);
  vtkDataArray* error = Require(observers, Names::IndirectIlluminanceStandardError);
  const auto rating = AddColumn(observers, Names::UGR), ratingError = AddColumn(observers, Names::UGRStandardError);
  const auto background = AddColumn(observers, Names::BackgroundLuminance);
  const auto backgroundError = AddColumn(observers, Names::BackgroundLuminanceStandardError);
  auto sources = vtkSmartPointer<vtkIntArray>::New();
  sources->SetName(Names::GlareSources);
  sources->SetNumberOfComponents(3);
  observers->GetPointData()->AddArray(sources);
  for (vtkIdType i = 0; i < observers->GetNumberOfPoints(); ++i)
  {
    const kalos::GlareSum glare = kalos::glareSum(scene, ReadObserver(observers, normals, ups, i));
    const double indirect = total->GetTuple1(i) - direct->GetTuple1(i);
    rating->SetValue(i, kalos::unifiedGlareRating(glare.sum, indirect));
    ratingError->SetValue(i, 8 / std::log(10.0) * error->GetTuple1(i) / indirect);
    background->SetValue(i, indirect / kalos::pi);
    backgroundError->SetValue(i, error->GetTuple1(i) / kalos::pi);
    const int counts[3] = {glare.sources, glare.small, glare.large};
    sources->InsertNextTypedTuple(counts);
  }
}
}  // namespace

int vtkKalosGlareRating::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    output->ShallowCopy(vtkPolyData::GetData(inputs[0]));
    Rate(output,
         kalos::Scene(MakeSceneDescription(vtkDataObject::GetData(inputs[1]), vtkPolyData::GetData(inputs[2]))));
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
