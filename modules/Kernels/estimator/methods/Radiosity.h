// SPDX-License-Identifier: BSD-3-Clause
// Also known as: the finite-element method of global illumination (Goral et al. 1984; Galerkin radiosity, Zatz 1993).
// What RELUX, AGi32 and the older DIALux show.
//
// Method `radiosity`: the lit sides of all triangles are cut into elements on which the indirect illuminance is
// constant or linear, the equations between them are solved (estimator/methods/RadiositySystem.h), and a receiver on a
// surface reads its element. With MethodOptions::finalGather, and at receivers in the air, cosine-weighted rays leave
// the receiver instead and read the elements' exitance where they end. Direct illuminance is exact.
//
// Elements are as long as Settings::epsilon at most; automatic: so many that their number is four times the root of the
// trajectories. Each round draws visibility anew, so that the error bars hold the noise of that. Bias: the elements'
// error; it does not fall with rounds, only with shorter elements. The audit states it: by how much the values
// differ from those of elements twice as long (half as long, where whole triangles are elements). Diffuse scenes only.
// Memory grows as the square of the elements' number, and is refused before it is taken; there are no hierarchical
// links.
#ifndef kalos_estimator_methods_Radiosity_h
#define kalos_estimator_methods_Radiosity_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/methods/Estimator.h"
#include "estimator/methods/RadiositySystem.h"

namespace kalos
{
class Radiosity : public Estimator
{
public:
  /// Throws std::invalid_argument where a surface is not diffuse, or the form factors would not fit into memory.
  Radiosity(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool trusts(std::size_t receiver, long long trajectories) const override;
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  Pace pace() const override;
  std::vector<AuditLine> audit() const override;

private:
  // Where a receiver reads the elements.
  struct Reading
  {
    bool onElement = false;
    RadiosityMesh::Place place;
  };
  void refuse() const;
  void findElements();
  Reading reading(const RadiosityMesh& mesh, const Sensor& sensor) const;
  RadiositySystem system(const RadiosityMesh& mesh) const;
  // Indirect light at receiver r by a solved system, of `rays` gather rays from the first on where they are needed, and
  // the part of it that is straight from meshes; lx per band.
  struct Light
  {
    Bands all{}, fromMeshes{};
  };
  Light lightAt(std::size_t r, const RadiosityMesh& mesh, const RadiositySystem& solved, int replicate, long long first,
                int rays) const;
  bool compare(Workers& workers, std::size_t receivers);

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  DirectLight Luminaires;
  std::unique_ptr<LitSides> Sides;
  double Length = 0;  // of the elements, m
  std::unique_ptr<RadiosityMesh> Mesh;
  std::vector<float> Difference;  // from elements twice as long, relative to the indirect light, per receiver
  double MeanDifference = 0, RmsDifference = 0, Residual = 0;
  int Iterations = 0, Replicates = 1;
  const char* ComparedWith = "";  // elements how long
};
}  // namespace kalos

#endif
