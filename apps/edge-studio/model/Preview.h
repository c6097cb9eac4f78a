// SPDX-License-Identifier: BSD-3-Clause
// First colours: some of the receivers stand for all, until the first full round is there.
#ifndef studio_Preview_h
#define studio_Preview_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// About `wanted` receivers, evenly taken from the cells of all blocks; null where there are not many more than that.
vtkSmartPointer<vtkDataObject> someReceivers(vtkDataObject* receivers, int wanted);

/// The receivers with the cell arrays of results on some of them: every cell takes those of the nearest that was solved
/// and faces the same of the six directions of the axes.
vtkSmartPointer<vtkDataObject> spread(vtkDataObject* solved, vtkDataObject* receivers);
}  // namespace studio

#endif
