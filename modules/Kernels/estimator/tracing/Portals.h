// SPDX-License-Identifier: BSD-3-Clause
// Also known as: portal sampling; path guiding through small openings.
//
// Small openings between the light and the receivers, and how directions are aimed at them.
//
// From where light comes, a trajectory sends a child through a portal at each collision, and at its start. The child
// and the trajectory's own next direction share the light by the balance heuristic: both weigh it over p_portal +
// p_own, the densities with which the two are drawn, so that no child carries more light than its parent. Roulette
// keeps about one child of equal flux per trajectory and portal. On the other side, gather rays are aimed at a portal
// in one half of the cases, and take all light that arrives through it: vertices beyond it do not score. Every portal
// that is not one, or that is too large or too small, costs time but adds no bias.
#ifndef kalos_estimator_tracing_Portals_h
#define kalos_estimator_tracing_Portals_h

#include <array>
#include <cstdint>

#include "estimator/tracing/RegionMap.h"

namespace kalos
{
/// A rectangle that light passes on its way to the receivers.
struct Portal
{
  Vec3 corner, u, v;           ///< m, in the scene's coordinates; u and v at right angles
  Vec3 onward;                 ///< unit, across it, away from the light
  double area = 0;             ///< m2
  std::uint32_t triangle = 0;  ///< in its plane
  double flux = 0;             ///< lm, mean flux that a trajectory sends through it

  Vec3 point(double s, double t) const { return this->corner + s * this->u + t * this->v; }
  /// Whether the line from p along d meets it at p + t d, t > 0.
  bool meets(const Vec3& p, const Vec3& d, double& t) const;
};

class Portals
{
public:
  static constexpr std::size_t most = 8;
  using Mask = std::uint8_t;  ///< bit k: portal k

  Portals() = default;
  /// The masks say which portals are seen: from each of the map's regions, from the side of the light and from the
  /// other, and from each luminaire.
  Portals(std::vector<Portal> portals, RegionMap map, std::vector<Mask> fromLight, std::vector<Mask> beyond,
          std::vector<Mask> fromLuminaires);

  bool any() const { return !this->All.empty(); }
  const std::vector<Portal>& all() const { return this->All; }

  /// Portals that trajectories from a point of a surface, and gather rays to it, are aimed at.
  Mask forTrajectories(const Vec3& p, const Vec3& n) const { return this->mask(this->FromLight, p, n, true); }
  Mask forLuminaire(std::size_t luminaire) const { return this->any() ? this->FromLuminaires[luminaire] : Mask{0}; }
  Mask forGatherRays(const Vec3& p, const Vec3& n) const { return this->mask(this->Beyond, p, n, false); }

  /// A direction from p to a point of one of the portals; u in [0,1).
  struct Aim
  {
    Vec3 direction;
    int portal;
  };
  Aim aim(Mask portals, const Vec3& p, double u0, double u1, double u2) const;

  /// A direction for a gather ray of a sensor: one half is aimed, one half cosine-weighted, with this density per sr.
  Vec3 gather(Mask portals, const Vec3& p, const Vec3& n, std::array<double, 3> u, double& density) const;

  /// The density per sr of aim().
  double density(Mask portals, const Vec3& p, const Vec3& direction) const;

  /// Whether the segment from p to q passes one of the portals.
  bool cross(Mask portals, const Vec3& p, const Vec3& q) const;

private:
  Mask mask(const std::vector<Mask>& ofRegions, const Vec3& p, const Vec3& n, bool before) const;
  double shares(Mask portals, const Vec3& p, double* share) const;  // in which portals are chosen; returns their sum

  std::vector<Portal> All;
  RegionMap Map;
  std::vector<Mask> FromLight, Beyond;  // per region
  std::vector<Mask> FromLuminaires;
};
}  // namespace kalos

#endif
