// SPDX-License-Identifier: BSD-3-Clause
// From VTK data sets with normals to the kernels' receivers, and results back.
#ifndef ReceiverConversion_h
#define ReceiverConversion_h

#include <vector>

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"

class vtkDataSet;

/// Appends a data set's receivers: its points where it has point normals, else its cell centres where it has cell
/// normals; with what their arrays EdgeDistance and EdgeAngle say. Throws std::invalid_argument when it has neither or
/// a normal is not of finite, non-zero length.
void AppendReceivers(vtkDataSet* dataSet, kalos::Receivers& receivers);

/// Attaches the results of receivers [first, ...) to the data set that AppendReceivers() took them from; returns the
/// number of the next receiver. `valid` has the flag Valid of every receiver.
std::size_t AttachResults(const kalos::Result& result, const std::vector<char>& valid, std::size_t first,
                          vtkDataSet* dataSet);

#endif
