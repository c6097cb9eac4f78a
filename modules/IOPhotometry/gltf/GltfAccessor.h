// SPDX-License-Identifier: BSD-3-Clause
/** Reads numbers from the buffers of a glTF. */
#ifndef KalosGltfAccessor_h
#define KalosGltfAccessor_h

#include <vector>

#include "GltfFile.h"

namespace kalos::scene
{
/** The elements of the accessor that `number` names, which is of this type; normalised integers become fractions. */
std::vector<double> readVectors(const GltfFile& file, const JsonCursor& number, const std::string& type);
std::vector<Vector3> readPoints(const GltfFile& file, const JsonCursor& number);
/** Unsigned integers of a SCALAR accessor. */
std::vector<std::uint32_t> readIndices(const GltfFile& file, const JsonCursor& number);
}  // namespace kalos::scene

#endif
