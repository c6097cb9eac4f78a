// SPDX-License-Identifier: BSD-3-Clause
/** The "receivers" of a scene file. */
#ifndef KalosSceneReceivers_h
#define KalosSceneReceivers_h

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "SceneSurfaces.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/** In a scene file; several hundred bytes each in memory. */
constexpr std::int64_t MaximumReceivers = 5000000;

/** What is expected of a set where the others leave room for `most`. */
std::string fewerReceivers(std::int64_t most);

/**
 * Cells of a u x v plane by the grid of EN 12464-1: spacing p = 0.2 * 5^log10(d), at most 10 m, d the longer side in
 * metres, or the shorter one of a plane at least twice as long as wide; the nearest whole number of cells to each side
 * over p. None if that is more than 10 000 along a side.
 */
std::optional<std::array<int, 2>> standardGrid(double u, double v);

/**
 * Read the array "receivers" into one named block each, in file order. `names` holds the names of result files already
 * given away; the receivers' are added. Files that lie elsewhere are added to `notes` (FilePaths.h). More than
 * MaximumReceivers in all are an error.
 */
vtkSmartPointer<vtkMultiBlockDataSet> readReceivers(const JsonCursor& scene, const std::vector<Surface>& surfaces,
                                                    const std::string& folder, std::set<std::string>& names,
                                                    Notes& notes);
}  // namespace kalos::scene

#endif
