// SPDX-License-Identifier: BSD-3-Clause
// Techniques that make a solve cheaper without bias. Each can be disabled by its name:
//   stratified     walks stratified by Sobol' points (sampling/SampleStream.h), and vertices over space
//                  (estimator/tracing/VertexOrder.h); disabled: independent numbers
//   picked         shadow rays to vertices picked by their unshadowed scores; disabled: one to every pair that scores
//   convex         no shadow rays where the audit shows that nothing can occlude
//   near           gather rays only at receivers with a surface near in front
//   paths          no vertices where paths from the receivers win a trial (estimator/methods/StrategyTrial.h)
//   neighbours     gather rays shared by neighbouring receivers (estimator/gathering/ReceiverGroup.h)
//   effort         receivers that reached the goal are skipped (estimator/solve/AdaptiveSampling.h)
//   highlights     light of luminaires by glossy planes sampled about mirror images (estimator/direct/Highlights.h);
//                  disabled: by vertices and gather rays
//   exact-direct   area emitters by Lambert's polygon formula, sampling only their visibility; disabled: all sampled,
//                  and emitting meshes by the starts of trajectories
#ifndef kalos_estimator_control_Techniques_h
#define kalos_estimator_control_Techniques_h

#include <initializer_list>
#include <string>

namespace kalos
{
enum class Technique
{
  Stratified,
  Picked,
  Convex,
  Near,
  Paths,
  Neighbours,
  Effort,
  Highlights,
  ExactDirect
};

class TechniqueSet
{
public:
  TechniqueSet() = default;
  TechniqueSet(std::initializer_list<Technique> techniques)
  {
    for (const Technique t : techniques)
      this->insert(t);
  }

  /// The techniques of these names, separated by commas. Throws std::invalid_argument for an unknown name.
  static TechniqueSet named(const std::string& names);

  /// Their names, separated by commas.
  std::string names() const;

  bool contains(Technique t) const { return (this->Bits & bit(t)) != 0; }
  void insert(Technique t) { this->Bits |= bit(t); }

private:
  static unsigned bit(Technique t) { return 1u << static_cast<unsigned>(t); }

  unsigned Bits = 0;
};
}  // namespace kalos

#endif
