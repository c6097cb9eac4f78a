// SPDX-License-Identifier: BSD-3-Clause
// When a standard error can be believed.
//
// Rule. The interval of a receiver is trusted unless
//  (1) one single score makes up more than half of the variance, x_max / N > SE / sqrt(2), and it stands out: it
//      exceeds three times the median of the replicates' largest scores. With a finite variance the first ratio falls
//      as 1/sqrt(N); with the kernel's tail, whose variance is unbounded, it does not. Stratified walks make SE so
//      small that a bounded score can pass for half of it, but then every replicate has one like it; of a tail that
//      falls as 1/x (kernels at an edge) the largest of 32 stays within three medians once in 2400 times, of 16 once in
//      38, of 8 once in five: methods with so few replicates have bounded scores; or
//  (2) the method scores the plain kernel and the vertices are too sparse to see the receiver's surroundings: of 64
//      cosine-weighted probe rays from the receiver the third largest kernel G (so 4 % of the irradiating hemisphere)
//      has fewer than 10 vertices expected in its area 1/G. Then the spikes that carry that light are probably not
//      sampled yet, and the standard error is too small; or
//  (3) hardly any of the vertices picked for it, or for what its gather rays find, was seen, and those that hide might
//      still matter: with `seen` < 16 of `tried` picks seen, as many as seen + 3 + 1.7 sqrt(seen) might be expected
//      (Poisson, one-sided 95 %); the light that these would bring exceeds both two standard errors and a twentieth of
//      the value. A room behind a small opening, or a dim one beside a bright one: all replicates agree about what they
//      have missed.
#ifndef kalos_estimator_tally_IntervalDiagnostics_h
#define kalos_estimator_tally_IntervalDiagnostics_h

#include "estimator/kernel/Sensor.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
/// Rule (1); `standsOut` is Tally::largestStandsOut().
bool tailIsLight(double largestScoreShare, bool standsOut, const MeanAndError& estimate);

/// The third largest kernel (1/m2) of 64 probe rays; 0 when fewer rays than that meet a surface.
double nearKernel(const Scene& scene, const Sensor& sensor);

/// Rule (3); `samples`: trajectories of all replicates.
bool hiddenIsLittle(const PickCount& picks, double samples, const MeanAndError& estimate);

/// Rule (2), for vertices of `density` per m2.
bool nearFieldIsSeen(double nearKernel, double density);
}  // namespace kalos

#endif
