// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceJoining.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "vtkAlgorithm.h"
#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace Names = vtkKalosArrayNames;

namespace
{
constexpr std::array<const char*, 5> properties{Names::Reflectance, Names::Exitance, Names::Specular, Names::Roughness,
                                                Names::Mirror};

struct Block
{
  std::string name;
  vtkSmartPointer<vtkPolyData> polygons;
};

vtkSmartPointer<vtkPolyData> PolygonsOf(vtkDataSet* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (data->IsA("vtkPolyData"))
  {
    copy->ShallowCopy(data);
    return copy;
  }
  vtkNew<vtkDataSetSurfaceFilter> faces;
  faces->SetInputData(data);
  faces->Update();
  copy->ShallowCopy(faces->GetOutput());
  copy->GetFieldData()->ShallowCopy(data->GetFieldData());
  return copy;
}

std::string NameOf(vtkInformation* information, std::size_t number)
{
  const char* name = information ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "block " + std::to_string(number);
}

std::vector<Block> BlocksOf(vtkDataObject* surfaces)
{
  std::vector<Block> blocks;
  auto add = [&](vtkDataObject* leaf, vtkInformation* information) {
    if (auto* data = vtkDataSet::SafeDownCast(leaf))
      blocks.push_back({NameOf(information, blocks.size()), PolygonsOf(data)});
  };
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(surfaces))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      for (unsigned int k = 0; k < collection->GetNumberOfPartitions(i); ++k)
        add(collection->GetPartitionAsDataObject(i, k),
            collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr);
    return blocks;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(surfaces);
  if (!composite)
  {
    add(surfaces, nullptr);
    return blocks;
  }
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    add(iterator->GetCurrentDataObject(), iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData() : nullptr);
  return blocks;
}

/// The array of a block's cells, or the one tuple for all of them; null where it has none.
vtkDataArray* Given(vtkPolyData* block, const char* name)
{
  vtkDataArray* ofCells = block->GetCellData()->GetArray(name);
  vtkDataArray* ofAll = block->GetFieldData()->GetArray(name);
  return ofCells ? ofCells : ofAll && ofAll->GetNumberOfTuples() == 1 ? ofAll : nullptr;
}

/// Gives the block a cell array of so many components; a single one stands for all bands.
void Fill(vtkPolyData* block, const char* name, int components)
{
  vtkDataArray* given = Given(block, name);
  const bool ofAll = given && given != block->GetCellData()->GetArray(name);
  vtkNew<vtkDoubleArray> filled;
  filled->SetName(name);
  filled->SetNumberOfComponents(components);
  filled->SetNumberOfTuples(block->GetNumberOfCells());
  for (vtkIdType i = 0; i < block->GetNumberOfCells(); ++i)
    for (int c = 0; c < components; ++c)
      filled->SetComponent(
          i, c, given ? given->GetComponent(ofAll ? 0 : i, std::min(c, given->GetNumberOfComponents() - 1)) : 0);
  block->GetCellData()->AddArray(filled);
}

void Equip(std::vector<Block>& blocks)
{
  for (const char* name : properties)
  {
    int components = 0;
    for (const Block& block : blocks)
      if (vtkDataArray* given = Given(block.polygons, name))
        components = std::max(components, given->GetNumberOfComponents());
    for (Block& block : blocks)
    {
      if (name == Names::Reflectance && !Given(block.polygons, name))
        throw std::invalid_argument("surfaces: " + block.name + ": neither a cell array nor a field array Reflectance");
      if (components > 0)
        Fill(block.polygons, name, components);
    }
  }
}
}  // namespace

int AcceptAnyData(vtkInformation* port)
{
  // The composite type comes first: all blocks are solved together, not one by one.
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

std::vector<vtkDataSet*> LeavesOf(vtkDataObject* object)
{
  std::vector<vtkDataSet*> leaves;
  if (auto* dataSet = vtkDataSet::SafeDownCast(object))
    leaves.push_back(dataSet);
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      if (auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
        leaves.push_back(leaf);
  }
  return leaves;
}

vtkMTimeType ModifiedTime(vtkDataObject* object)
{
  vtkMTimeType latest = object->GetMTime();
  for (vtkDataSet* leaf : LeavesOf(object))
    latest = std::max(latest, leaf->GetMTime());
  return latest;
}

vtkSmartPointer<vtkPolyData> JoinSurfaces(vtkDataObject* surfaces)
{
  if (auto* polygons = vtkPolyData::SafeDownCast(surfaces))
    return polygons;
  std::vector<Block> blocks = BlocksOf(surfaces);
  Equip(blocks);
  vtkNew<vtkAppendPolyData> append;
  vtkNew<vtkStringArray> names;
  names->SetName(Names::SurfaceNames);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName(Names::SurfaceId);
    ids->SetNumberOfTuples(blocks[i].polygons->GetNumberOfCells());
    ids->FillValue(static_cast<int>(i));
    blocks[i].polygons->GetCellData()->AddArray(ids);
    names->InsertNextValue(blocks[i].name);
    append->AddInputData(blocks[i].polygons);
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  if (!blocks.empty())
  {
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  joined->GetFieldData()->AddArray(names);
  return joined;
}
