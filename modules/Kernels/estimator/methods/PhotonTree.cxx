// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/PhotonTree.h"

#include <nanoflann.hpp>

namespace kalos
{
namespace
{
constexpr float sameSide = 0.7f;  // cosine between the normals of a photon and the sensor that it counts for

struct Found
{
  std::size_t photon;
  float squared;  // m2, distance to the sensor
};
}  // namespace

struct PhotonTree::Photons
{
  using Metric = nanoflann::L2_Simple_Adaptor<float, Photons, float, std::size_t>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Photons, 3, std::size_t>;

  explicit Photons(int bands) : Flux(static_cast<std::size_t>(bands)) {}

  // What nanoflann asks for.
  std::size_t kdtree_get_point_count() const { return this->Position.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t dimension) const { return this->Position[i][dimension]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }

  std::vector<std::array<float, 3>> Position, Normal;
  std::vector<Vec3> Incident;            // unit, towards where the light comes from
  std::vector<std::vector<float>> Flux;  // lm, per band
  std::vector<char> FirstOfMesh;
  std::unique_ptr<Tree> Index;
};

namespace
{
// nanoflann's result set that keeps the photons that count: all within the radius, or the nearest.
class Nearest
{
public:
  using DistanceType = float;

  template <class Counts>
  Nearest(const PhotonLookup& lookup, const Counts& counts)
      : Most(static_cast<std::size_t>(lookup.nearest)),
        Worst(static_cast<float>(lookup.radius * lookup.radius)),
        Accept(counts)
  {
  }

  bool full() const { return true; }  // worstDist() always bounds the search
  std::size_t size() const { return this->Photons.size(); }
  float worstDist() const { return this->Worst; }
  bool addPoint(float squared, std::size_t photon)
  {
    if (!(squared < this->Worst) || !this->Accept(photon))
      return true;
    this->Photons.push_back({photon, squared});
    if (this->Most == 0)
      return true;
    std::push_heap(this->Photons.begin(), this->Photons.end(), nearer);
    if (this->Photons.size() > this->Most)
    {
      std::pop_heap(this->Photons.begin(), this->Photons.end(), nearer);
      this->Photons.pop_back();
    }
    if (this->Photons.size() == this->Most)
      this->Worst = this->Photons.front().squared;
    return true;
  }

  // The photons that count, and the squared radius of the disc that they lie on. The farthest of the nearest ones marks
  // the disc's border, so that it does not count.
  const std::vector<Found>& take(float& squaredRadius)
  {
    squaredRadius = this->Worst;
    if (this->Most > 0 && this->Photons.size() == this->Most)
    {
      std::pop_heap(this->Photons.begin(), this->Photons.end(), nearer);
      this->Photons.pop_back();
    }
    return this->Photons;
  }

private:
  static bool nearer(const Found& a, const Found& b) { return a.squared < b.squared; }

  std::size_t Most;
  float Worst;
  std::function<bool(std::size_t)> Accept;
  std::vector<Found> Photons;
};
}  // namespace

PhotonTree::PhotonTree(int bands) : Impl(std::make_unique<Photons>(bands)) {}
PhotonTree::~PhotonTree() = default;
PhotonTree::PhotonTree(PhotonTree&&) noexcept = default;
PhotonTree& PhotonTree::operator=(PhotonTree&&) noexcept = default;

void PhotonTree::add(const SurfacePoint& point, const Vec3& towardsLight, const Bands& weight, bool firstOfMesh)
{
  auto single = [](const Vec3& v) {
    return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  Photons& all = *this->Impl;
  all.Position.push_back(single(point.position));
  all.Normal.push_back(single(point.normal));
  all.Incident.push_back(towardsLight);
  for (std::size_t b = 0; b < all.Flux.size(); ++b)
    all.Flux[b].push_back(static_cast<float>(weight[b]));
  all.FirstOfMesh.push_back(firstOfMesh);
}

void PhotonTree::build()
{
  this->Impl->Index = std::make_unique<Photons::Tree>(3, *this->Impl);
}

PhotonEstimate PhotonTree::estimate(const Sensor& sensor, const PhotonLookup& lookup) const
{
  PhotonEstimate found;
  const Photons& all = *this->Impl;
  if (all.Position.empty())
    return found;
  const Vec3& n = sensor.normal;
  const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  Nearest nearest(lookup, [&](std::size_t i) {
    const auto& m = all.Normal[i];
    return normal[0] * m[0] + normal[1] * m[1] + normal[2] * m[2] > sameSide &&
           (lookup.firstOfMeshes || !all.FirstOfMesh[i]);
  });
  const Vec3& p = sensor.position;
  const float at[3] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  all.Index->findNeighbors(nearest, at, nanoflann::SearchParams());
  float squaredRadius;
  const std::vector<Found>& photons = nearest.take(squaredRadius);
  const int bands = static_cast<int>(all.Flux.size());
  const double constant = 1 / (pi * static_cast<double>(squaredRadius));
  for (const auto& [i, squared] : photons)
  {
    const double away = std::sqrt(static_cast<double>(squared / squaredRadius));  // over the radius
    const double filter = lookup.cone ? 3 * (1 - away) * constant : constant;
    const Bands seen = response(sensor, all.Incident[i], bands);
    Bands light{};
    for (int b = 0; b < bands; ++b)
      light[b] = seen[b] * static_cast<double>(all.Flux[static_cast<std::size_t>(b)][i]);
    const double luminous = photometric(light, bands);
    for (int b = 0; b < bands; ++b)
    {
      found.light[b] += filter * light[b];
      found.direct[b] += all.FirstOfMesh[i] ? filter * light[b] : 0;
    }
    if (away < 0.5)
      found.halfRadius += (lookup.cone ? 3 * (1 - 2 * away) : 1) * 4 * constant * luminous;
    found.largest = std::max(found.largest, filter * luminous);
  }
  return found;
}
}  // namespace kalos
