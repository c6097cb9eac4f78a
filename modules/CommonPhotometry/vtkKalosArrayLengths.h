// SPDX-License-Identifier: BSD-3-Clause
/**
 * Arrays that are shorter than what they describe: VTK hands them on, and who reads them reads other memory.
 */
#ifndef vtkKalosArrayLengths_h
#define vtkKalosArrayLengths_h

#include <stdexcept>
#include <string>

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

namespace vtkKalosArrayLengths
{
/** Throws std::invalid_argument, naming the array, unless all have `count` tuples; `things` are what they are of. */
inline void Require(vtkDataSetAttributes* data, vtkIdType count, const char* things)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() != count)
    {
      throw std::invalid_argument(std::string(array->GetName() ? array->GetName() : "an array without a name") +
                                  ": has " + std::to_string(array->GetNumberOfTuples()) +
                                  " tuples, expected one for each of the " + std::to_string(count) + " " + things);
    }
  }
}
}  // namespace vtkKalosArrayLengths

#endif
