// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/PortalPilot.h"

#include <algorithm>
#include <cmath>

#include "estimator/tracing/PilotPaths.h"
#include "estimator/tracing/PortalFit.h"
#include "estimator/tracing/Trajectories.h"

namespace kalos
{
namespace
{
constexpr int firstPaths = 128, mapPaths = 2048, batch = 4096, mostPaths = 1 << 17,
              mostOfFew = 1 << 19;                              // of each kind
constexpr std::ptrdiff_t firstRegion = 16, largestRegion = 48;  // points
constexpr double unlit = 2.3;                                   // contrast, log: less than a tenth of the light
constexpr double mostUnlit = 0.3, surelyUnlit = 0.45;           // of the points that a sensor's paths reach
constexpr double steep = 6.9;                            // difference of contrasts, log, on both sides of an opening
constexpr std::size_t enough = 16, few = 6, fewest = 3;  // segments
constexpr int visibilityRays = 8;                        // per region or luminaire and portal
constexpr double leastSeen = 0.02;                       // of the rays aimed at a portal that must pass
constexpr int firstReplicate = pilotReplicate + 128;

class Search
{
public:
  Search(const Scene& scene, const Emission& emission, const std::vector<Sensor>& sensors, const Walks& walks)
      : Scene_(scene),
        Source(emission),
        Sensors(sensors),
        Drawn(walks),
        Random(walks.seed, firstReplicate, Purpose::Portal, 0)
  {
  }

  Portals run()
  {
    this->explore(0, firstPaths, firstRegion);
    if (!this->isDark(mostUnlit))
      return {};
    this->explore(firstPaths, mapPaths, largestRegion);
    if (!this->isDark(surelyUnlit))
      return {};
    this->findSegments();
    std::vector<Portal> found = this->fit();
    return found.empty() ? Portals() : this->finish(std::move(found));
  }

private:
  // Paths of both kinds, for the map.
  void explore(int first, int count, std::ptrdiff_t region)
  {
    auto note = [this](const PilotPoint& at) {
      this->Points.push_back({at.point.position, at.point.normal, at.fromReceivers});
      this->Reached.push_back(at.sensor);
      if (!at.fromReceivers)
        this->Light.push_back({at.point, at.flux});
    };
    visitLight(this->Scene_, this->Source, this->Drawn, firstReplicate, first, count, note);
    visitImportance(this->Scene_, this->Sensors, this->Drawn, firstReplicate, first, count, note);
    this->Traced = first + count;
    this->Map = RegionMap(this->Points, region);
  }

  // Whether at least one in ten sensors reaches more than this share of points that are not lit.
  bool isDark(double share) const
  {
    std::vector<double> all(this->Sensors.size()), dark(this->Sensors.size());
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const RegionMap::Point& p = this->Points[i];
      if (!p.fromReceivers)
        continue;
      all[this->Reached[i]] += 1;
      dark[this->Reached[i]] += this->Map.contrast(p.position, p.normal) > unlit;
    }
    std::size_t count = 0;
    for (std::size_t r = 0; r < all.size(); ++r)
      count += dark[r] > share * all[r];
    return !this->Light.empty() && 10 * count >= all.size();
  }

  // Whether a surface point sees most of the points of this kind that are kept of its region, all lifted off their
  // surfaces: a region may have points on both sides of a wall.
  bool belongs(const SurfacePoint& at, bool fromReceivers) const
  {
    const int region = this->Map.find(at.position, at.normal);
    if (region == RegionMap::none)
      return false;
    int seen = 0, all = 0;
    for (const RegionMap::Point& p : this->Map.regions()[static_cast<std::size_t>(region)].some)
    {
      if (p.fromReceivers != fromReceivers)
        continue;
      const double height = 0.1 * length(p.position - at.position);
      ++all;
      seen += !this->Scene_.rays().occluded(at.position + height * at.normal, p.position + height * p.normal);
    }
    return 2 * seen > all;
  }

  void findSegments()
  {
    auto note = [this](const PilotPoint& at) {
      if (at.first)
        return;
      const SurfacePoint& lit = at.fromReceivers ? at.point : at.before;
      const SurfacePoint& dark = at.fromReceivers ? at.before : at.point;
      if (this->Map.contrast(dark.position, dark.normal) - this->Map.contrast(lit.position, lit.normal) > steep &&
          this->belongs(lit, false) && this->belongs(dark, true))
        this->Segments.push_back({lit, dark});
    };
    auto goesOn = [this](int paths) {
      const std::size_t found = this->Segments.size();
      return paths < mostPaths ? found < enough : paths < mostOfFew && found > 0 && found < few;
    };
    for (int first = 0; goesOn(first); first += batch)
    {
      visitLight(this->Scene_, this->Source, this->Drawn, firstReplicate + 1, first, batch, note);
      visitImportance(this->Scene_, this->Sensors, this->Drawn, firstReplicate + 1, first, batch, note);
    }
  }

  // Fits portals to the segments, one after the other, and corrects each by rays through it.
  std::vector<Portal> fit()
  {
    std::vector<Portal> found;
    while (found.size() < Portals::most && this->Segments.size() >= fewest)
    {
      Portal portal;
      if (!fitPortal(this->Scene_, this->Segments, this->Random, portal))
        break;
      if (this->refine(portal))
        found.push_back(portal);
    }
    return found;
  }

  bool refine(Portal& portal)
  {
    std::vector<Vec3> lit;
    for (const LightPoint& p : this->Light)
      if (this->Map.contrast(p.at.position, p.at.normal) < 0)
        lit.push_back(this->Scene_.anchor(p.at).lifted());
    return !lit.empty() && correctPortal(this->Scene_, lit, leastSeen, this->Random, portal);
  }

  // Whether a point of a surface sees some of the portal.
  bool sees(const RayAnchor& from, const Portal& portal)
  {
    for (int i = 0; i < visibilityRays / 4; ++i)
    {
      const double s = this->Random.next(), t = this->Random.next();
      if (dot(portal.point(s, t) - from.point, from.normal) >= 0 &&
          !this->Scene_.rays().occluded(from, portal.point(s, t)))
        return true;
    }
    return false;
  }

  Portals finish(std::vector<Portal> portals)
  {
    const auto& regions = this->Map.regions();
    std::vector<Portals::Mask> before(regions.size()), beyond(regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i)
      for (std::size_t k = 0; k < portals.size(); ++k)
        for (const RegionMap::Point& p : regions[i].some)
          if (this->sees(this->Scene_.anchor(p.position, p.normal), portals[k]))
            (dot(p.position - portals[k].corner, portals[k].onward) < 0 ? before : beyond)[i] |=
                static_cast<Portals::Mask>(1u << k);
    std::vector<Portals::Mask> ofLuminaires(this->Source.luminaires());
    for (std::size_t l = 0; l < ofLuminaires.size(); ++l)
      for (std::size_t k = 0; k < portals.size(); ++k)
        for (int i = 0; i < 4; ++i)
          if (this->sees(RayAnchor(this->Scene_.luminaireAnchor(l).lifted()), portals[k]) &&
              dot(this->Scene_.luminaireAnchor(l).point - portals[k].corner, portals[k].onward) < 0)
            ofLuminaires[l] |= static_cast<Portals::Mask>(1u << k);
    this->measureFlux(portals);
    return Portals(std::move(portals), std::move(this->Map), std::move(before), std::move(beyond),
                   std::move(ofLuminaires));
  }

  // The mean flux that a trajectory sends through each, by its collisions.
  void measureFlux(std::vector<Portal>& portals)
  {
    for (Portal& portal : portals)
      for (const LightPoint& p : this->Light)
      {
        const double s = this->Random.next(), t = this->Random.next();
        const Vec3 q = portal.point(s, t), d = q - p.at.position;
        const double squared = dot(d, d), here = dot(d, p.at.normal), there = dot(d, portal.onward);
        if (here > 0 && there > 0 && !this->Scene_.rays().occluded(this->Scene_.anchor(p.at), q))
          portal.flux += p.flux * portal.area * here * there / (pi * squared * squared) / this->Traced;
      }
  }

  struct LightPoint
  {
    SurfacePoint at;
    double flux;
  };

  const Scene& Scene_;
  const Emission& Source;
  const std::vector<Sensor>& Sensors;
  Walks Drawn;
  RandomStream Random;
  int Traced = 0;  // trajectories whose collisions are kept
  std::vector<RegionMap::Point> Points;
  std::vector<std::size_t> Reached;  // the sensors of Points
  std::vector<LightPoint> Light;
  RegionMap Map;
  std::vector<PortalSegment> Segments;
};
}  // namespace

Portals findPortals(const Scene& scene, const Emission& emission, const std::vector<Sensor>& sensors,
                    const Walks& walks)
{
  return sensors.empty() ? Portals() : Search(scene, emission, sensors, walks).run();
}
}  // namespace kalos
