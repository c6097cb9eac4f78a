// SPDX-License-Identifier: BSD-3-Clause
/** Distances of receivers from the edges where the kernel is singular. */
#ifndef KalosReceiverDistances_h
#define KalosReceiverDistances_h

#include "singular/SingularEdges.h"

class vtkDataObject;

namespace kalos
{
/** Of an angle in radians; NaN for one that is not finite. */
double toDegrees(double radians);

/** A copy with data sets of its own, so that arrays added to them do not show in the input. */
void copyReceivers(vtkDataObject* input, vtkDataObject* output);

/**
 * Attach the arrays EdgeDistance and EdgeAngle to a data set, or to each of a multi-block: to its points, or to its
 * cells where only these have normals.
 */
void attachAllDistances(const meshing::Curves& all, bool bothSides, vtkDataObject* receivers);
}  // namespace kalos

#endif
