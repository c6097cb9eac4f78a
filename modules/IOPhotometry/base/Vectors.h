// SPDX-License-Identifier: BSD-3-Clause
/** Points and directions, m. */
#ifndef KalosVectors_h
#define KalosVectors_h

#include "mesh/Vector.h"  // of modules/Meshing

namespace kalos::scene
{
using Vector3 = meshing::Point;
}  // namespace kalos::scene

#endif
