// SPDX-License-Identifier: BSD-3-Clause
// The angles of an LM-63 file, completed to those of all directions.
#ifndef kalos_photometry_IesPlanes_h
#define kalos_photometry_IesPlanes_h

#include "photometry/PhotometricFile.h"
#include "photometry/PhotometryTable.h"

namespace kalos
{
/// Where the angles and the last intensity stand, for messages.
struct IesLines
{
  int angles = 0;
  int last = 0;
};

/// Rows of photometric type 1 (C), 2 (B, planes and angles exchanged) or 3 (A) become those of a full circle, by the
/// symmetry that the range of the angles stands for. Throws PhotometryError for ranges that stand for none.
void completeIesPlanes(PhotometryRows& rows, int type, const IesLines& lines, std::vector<PhotometryWarning>& warnings);
}  // namespace kalos

#endif
