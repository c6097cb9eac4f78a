// SPDX-License-Identifier: BSD-3-Clause
// A place, m, or a direction, with VTK's vector arithmetic.
#ifndef studio_Point_h
#define studio_Point_h

#include "vtkVector.h"
#include "vtkVectorOperators.h"

namespace studio
{
using Point = vtkVector3d;
}

#endif
