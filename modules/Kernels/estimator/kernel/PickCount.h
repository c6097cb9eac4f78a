// SPDX-License-Identifier: BSD-3-Clause
// What shadow rays to picked vertices have seen.
#ifndef kalos_estimator_kernel_PickCount_h
#define kalos_estimator_kernel_PickCount_h

namespace kalos
{
/// Light that vertices would send if nothing hid them, in the unit of a tally's totals; how many picks among them were
/// tried, and how many were seen. Doubles, because picks may count in part.
struct PickCount
{
  double possible = 0, tried = 0, seen = 0;

  void add(const PickCount& other, double times = 1)
  {
    this->possible += times * other.possible;
    this->tried += other.tried;
    this->seen += other.seen;
  }
};
}  // namespace kalos

#endif
