// SPDX-License-Identifier: BSD-3-Clause
#include "ReportTable.h"

#include "vtkTable.h"

namespace kalos
{
ReportTable::ReportTable(vtkTable* table)
{
  table->Initialize();
  this->Quantities->SetName("Quantity");
  this->Units->SetName("Unit");
  this->Values->SetName("Value");
  table->AddColumn(this->Quantities);
  table->AddColumn(this->Units);
  table->AddColumn(this->Values);
}

void ReportTable::add(const std::string& quantity, const char* unit, double value)
{
  this->Quantities->InsertNextValue(quantity);
  this->Units->InsertNextValue(unit);
  this->Values->InsertNextValue(value);
}
}  // namespace kalos
