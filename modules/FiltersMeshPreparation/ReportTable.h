// SPDX-License-Identifier: BSD-3-Clause
/** What a filter did, as a table. */
#ifndef KalosReportTable_h
#define KalosReportTable_h

#include <string>

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

class vtkTable;

namespace kalos
{
/** Columns Quantity, Unit (empty for counts) and Value; one row a quantity. */
class ReportTable
{
public:
  explicit ReportTable(vtkTable* table);
  void add(const std::string& quantity, const char* unit, double value);

private:
  vtkNew<vtkStringArray> Quantities, Units;
  vtkNew<vtkDoubleArray> Values;
};
}  // namespace kalos

#endif
