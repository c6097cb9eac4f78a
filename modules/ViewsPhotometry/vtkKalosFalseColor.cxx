// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosFalseColor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "UniformColors.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/** The data sets in a data set or composite. */
std::vector<vtkDataSet*> leaves(vtkDataObject* object)
{
  std::vector<vtkDataSet*> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto items = vtk::TakeSmartPointer(composite->NewIterator());
    for (items->InitTraversal(); !items->IsDoneWithTraversal(); items->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(items->GetCurrentDataObject()))
      {
        leaves.push_back(leaf);
      }
    }
  }
  else if (auto* leaf = vtkDataSet::SafeDownCast(object))
  {
    leaves.push_back(leaf);
  }
  return leaves;
}

/** Copy with leaves of its own, so that arrays added to them do not show in the input. */
void copyTree(vtkDataObject* input, vtkDataObject* output)
{
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  if (!from)
  {
    output->ShallowCopy(input);
    return;
  }
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  auto items = vtk::TakeSmartPointer(from->NewIterator());
  for (items->InitTraversal(); !items->IsDoneWithTraversal(); items->GoToNextItem())
  {
    auto leaf = vtk::TakeSmartPointer(items->GetCurrentDataObject()->NewInstance());
    leaf->ShallowCopy(items->GetCurrentDataObject());
    to->SetDataSet(items, leaf);
  }
  to->SetFieldData(from->GetFieldData());
}

/** Point data before cell data. */
vtkDataSetAttributes* attributesWith(vtkDataSet* leaf, const std::string& name)
{
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(leaf->GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(leaf->GetCellData())})
  {
    if (data->GetArray(name.c_str()))
    {
      return data;
    }
  }
  return nullptr;
}

/** The array of that name of each leaf that has it. */
std::vector<vtkDataArray*> arraysOf(const std::vector<vtkDataSet*>& leaves, const std::string& name)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkDataSet* leaf : leaves)
  {
    if (vtkDataSetAttributes* data = attributesWith(leaf, name))
    {
      arrays.push_back(data->GetArray(name.c_str()));
    }
  }
  return arrays;
}

/** Smallest and largest finite value (above 0 if so wanted); empty (first above second) if there is none. */
void widenRange(vtkDataArray* array, bool positive, double range[2])
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (std::isfinite(value) && (!positive || value > 0.0))
    {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
}

/** Give a range without extent some, so that a uniformly lit room has a legend too. */
void completeRange(bool logarithmic, double range[2])
{
  if (range[0] > range[1])
  {
    range[0] = logarithmic ? 1.0 : 0.0;
    range[1] = logarithmic ? 10.0 : 1.0;
  }
  else if (logarithmic)
  {
    range[0] = std::max(range[0], 1e-4 * range[1]);
    range[0] = range[0] < range[1] ? range[0] : 0.1 * range[1];
  }
  else if (range[0] == range[1])
  {
    (range[0] > 0.0 ? range[0] : range[1]) = range[0] == 0.0 ? 1.0 : 0.0;
  }
}

std::string unitOf(const std::string& name)
{
  using namespace vtkKalosArrayNames;
  for (const char* lux : {Illuminance, IlluminanceStandardError, DirectIlluminance})
  {
    if (name == lux)
    {
      return "lx";
    }
  }
  if (name == Luminance || name == LuminanceStandardError)
  {
    return "cd/m\xC2\xB2";
  }
  return name == Exitance ? "lm/m\xC2\xB2" : "";
}

/** The array that an empty ArrayName stands for. */
std::string defaultName(const std::vector<vtkDataSet*>& leaves)
{
  for (const char* name : {vtkKalosArrayNames::Illuminance, vtkKalosArrayNames::Luminance})
  {
    if (std::any_of(leaves.begin(), leaves.end(),
                    [&](vtkDataSet* leaf) { return attributesWith(leaf, name) != nullptr; }))
    {
      return name;
    }
  }
  return {};
}

bool isRange(const double range[2], bool logarithmic)
{
  const bool finite = std::isfinite(range[0]) && std::isfinite(range[1]);
  return finite && range[0] < range[1] && (!logarithmic || range[0] > 0.0);
}
}  // namespace

vtkStandardNewMacro(vtkKalosFalseColor);

vtkKalosFalseColor::vtkKalosFalseColor()
{
  const auto& colors = kalos::uniformColors();
  this->Table->SetNumberOfTableValues(static_cast<vtkIdType>(colors.size()));
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    this->Table->SetTableValue(static_cast<vtkIdType>(i), colors[i][0], colors[i][1], colors[i][2], 1.0);
  }
  const double grey = 128.0 / 255.0;
  this->Table->SetNanColor(grey, grey, grey, 1.0);
}

vtkKalosFalseColor::~vtkKalosFalseColor() = default;

vtkLookupTable* vtkKalosFalseColor::GetLookupTable()
{
  return this->Table;
}

int vtkKalosFalseColor::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkKalosFalseColor::RequestData(vtkInformation*, vtkInformationVector** inputVector,
                                    vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  const std::vector<vtkDataSet*> inputs = leaves(input);

  const std::string name = this->ArrayName.empty() ? defaultName(inputs) : this->ArrayName;
  const bool logarithmic = this->Scale == LOGARITHMIC;
  double range[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  const std::vector<vtkDataArray*> arrays = arraysOf(inputs, name);
  if (arrays.empty())
  {
    vtkErrorMacro("no array " << (name.empty() ? "Illuminance or Luminance" : name)
                              << "; expected it in point or cell data");
    return 0;
  }
  for (vtkDataArray* array : arrays)
  {
    if (array->GetNumberOfComponents() != 1)
    {
      vtkErrorMacro("the array " << name << " has " << array->GetNumberOfComponents() << " components; expected 1");
      return 0;
    }
    widenRange(array, logarithmic, range);
  }

  // Settle the range.
  completeRange(logarithmic, range);
  if (!this->AutomaticRange)
  {
    std::copy(this->Range, this->Range + 2, range);
    if (!isRange(range, logarithmic))
    {
      vtkErrorMacro("the range is " << range[0] << " to " << range[1]
                                    << "; expected two finite numbers, the second larger"
                                    << (logarithmic ? ", both above 0 on the logarithmic scale" : ""));
      return 0;
    }
  }
  std::copy(range, range + 2, this->UsedRange);
  // A range that the scale cannot hold is refused by the table: set the neutral one in between.
  this->Table->SetScaleToLinear();
  this->Table->SetRange(range);
  this->Table->SetScale(logarithmic ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
  this->UnitLabel = unitOf(name);

  // Colour the leaves.
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  copyTree(input, output);
  for (vtkDataSet* leaf : leaves(output))
  {
    this->AddColors(leaf, name);
  }
  return 1;
}

void vtkKalosFalseColor::AddColors(vtkDataSet* leaf, const std::string& name)
{
  vtkDataSetAttributes* data = attributesWith(leaf, name);
  if (!data)
  {
    return;
  }
  vtkDataArray* array = data->GetArray(name.c_str());
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName(ColorArrayName());
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double value = array->GetComponent(i, 0);
    if (!std::isnan(value))
    {
      value = std::clamp(value, this->UsedRange[0], this->UsedRange[1]);
    }
    colors->SetTypedTuple(i, this->Table->MapValue(value));
  }
  data->AddArray(colors);
}

void vtkKalosFalseColor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << (this->ArrayName.empty() ? "(Illuminance, else Luminance)" : this->ArrayName)
     << "\n";
  os << indent << "Scale: " << (this->Scale == LINEAR ? "linear" : "logarithmic") << "\n";
  os << indent << "AutomaticRange: " << (this->AutomaticRange ? "on" : "off") << "\n";
  os << indent << "Range: " << this->Range[0] << " to " << this->Range[1] << "\n";
  os << indent << "UsedRange: " << this->UsedRange[0] << " to " << this->UsedRange[1] << "\n";
}
