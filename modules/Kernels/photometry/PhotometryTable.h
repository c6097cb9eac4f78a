// SPDX-License-Identifier: BSD-3-Clause
// From the rows of a file, which use every symmetry, to a table over the full circle.
#ifndef kalos_photometry_PhotometryTable_h
#define kalos_photometry_PhotometryTable_h

#include "photometry/PhotometricFile.h"

namespace kalos
{
/// Planes with a row of candela each, as read; row p belongs to planes[p].
struct PhotometryRows
{
  std::vector<double> planes, angles;
  std::vector<std::vector<double>> candela;

  /// Appends the mirror image of every row about the plane `axis` that is not there yet, and sorts by plane.
  void mirrorPlanes(double axis);
  /// The same about the polar angle 0 (types A and B, where angles run from -90 to 90).
  void mirrorAngles();
  /// Reverses descending planes or angles; returns whether there were any.
  bool makeAscending();
  void scale(double factor);
  CandelaTable table(CandelaTable::Pole pole) const;
};

/// Throws unless the values ascend strictly (or all descend, where that is allowed).
void checkOrder(const std::vector<double>& values, int line, const std::string& field, bool mayDescend);
/// Throws on negative intensities and when all are zero; `line` is where the intensities end.
void checkCandela(const PhotometryRows& rows, int line);
}  // namespace kalos

#endif
