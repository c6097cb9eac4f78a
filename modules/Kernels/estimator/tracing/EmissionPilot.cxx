// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/EmissionPilot.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "estimator/kernel/VertexResampling.h"
#include "estimator/tracing/EmitterGroups.h"
#include "estimator/tracing/PortalPilot.h"
#include "estimator/tracing/Trajectories.h"
#include "estimator/tracing/VertexOrder.h"
#include "scene/Placement.h"
#include "scene/SceneNeeds.h"

namespace kalos
{
namespace
{
constexpr double defensive = 0.1;                      // share of the trajectories that stays in proportion to flux
constexpr double worthwhile = 0.75;                    // of the variance that is left, above which nothing changes
constexpr int perGroup = 64, mostTrajectories = 1024;  // of each half
constexpr std::size_t mostReceivers = 24;
constexpr int picks = 4;             // shadow rays per receiver and tile of a group
constexpr double nearShare = 0.002;  // of the scene's area: vertices nearer than its width are damped
constexpr int firstPilot = pilotReplicate + 64;
constexpr std::size_t mostStrata = 8;
constexpr double alike = 0.5;  // cosine of what two groups of a stratum give the receivers

// What each group gives each receiver, over what all groups give it.
struct Shares
{
  std::size_t receivers = 0;
  int groups = 0;
  std::vector<double> value;

  double& at(std::size_t r, int g) { return this->value[r * this->groups + g]; }
  double at(std::size_t r, int g) const { return this->value[r * this->groups + g]; }
  double squares(int g) const
  {
    double sum = 0;
    for (std::size_t r = 0; r < this->receivers; ++r)
      sum += this->at(r, g) * this->at(r, g);
    return sum;
  }
};

std::vector<Sensor> someSensors(const Scene& scene, const Receivers& receivers)
{
  const std::size_t all = receivers.points.size(), some = std::min(all, mostReceivers);
  std::vector<Sensor> sensors;
  for (std::size_t i = 0; i < some; ++i)
  {
    const std::size_t r = (2 * i + 1) * all / (2 * some);
    sensors.emplace_back(placeReceiver(scene, receivers.points[r] - scene.origin(), receivers.normals[r]));
  }
  return sensors;
}

// Adds the light that vertices of each group send to each sensor.
void score(const Scene& scene, const VertexSet& set, const std::vector<Sensor>& sensors, RandomStream& random,
           Shares& shares)
{
  forEachTile(set, [&](std::size_t begin, int count) {
    for (std::size_t r = 0; r < sensors.size(); ++r)
    {
      Bands sum{};
      addResampledScores(set, begin, count, sensors[r], nearShare, {&scene.rays(), picks, random.next()}, sum.data());
      shares.at(r, set.stratum[begin]) += photometric(sum, scene.bands());
    }
  });
}

// One half of the pilot.
Shares runPilot(const Scene& scene, const Emission& emission, const Walks& walks, int half, int groups,
                const std::vector<Sensor>& sensors)
{
  const int count = std::min(perGroup * groups, mostTrajectories), replicate = firstPilot + half;
  LightVertices pool = traceTrajectories(scene, emission, walks, replicate, 0, count);
  RandomStream random(walks.seed, static_cast<std::uint64_t>(replicate), Purpose::Selection, 0);
  Shares shares{sensors.size(), groups, std::vector<double>(sensors.size() * groups)};
  const bool startsScore = emission.emitters() - emission.luminaires() > largestExact;
  for (VertexSet* set : {&pool.reflected, &pool.glossy, &pool.emitted})
  {
    if (set == &pool.emitted && !startsScore)
      continue;
    separateStrata(*set);
    std::fill(set->inverseDensity.begin(), set->inverseDensity.end(), static_cast<float>(scene.surfaceArea()));
    score(scene, *set, sensors, random, shares);
  }
  for (std::size_t r = 0; r < sensors.size(); ++r)
  {
    const auto own = shares.value.begin() + static_cast<std::ptrdiff_t>(r * groups);
    const double total = std::accumulate(own, own + groups, 0.0);
    for (int g = 0; g < groups && total > 0; ++g)
      shares.at(r, g) /= total;
  }
  return shares;
}

std::vector<double> probabilities(const Shares& shares, const std::vector<double>& ofFlux)
{
  std::vector<double> p(ofFlux.size());
  for (int g = 0; g < shares.groups; ++g)
    p[g] = std::sqrt(shares.squares(g));
  const double sum = std::accumulate(p.begin(), p.end(), 0.0);
  for (std::size_t g = 0; g < p.size() && sum > 0; ++g)
    p[g] = defensive * ofFlux[g] + (1 - defensive) * p[g] / sum;
  return sum > 0 ? p : ofFlux;
}

double variance(const Shares& shares, const std::vector<double>& p)
{
  double sum = 0;
  for (int g = 0; g < shares.groups; ++g)
    sum += shares.squares(g) / p[g];
  return sum;
}

// Puts groups that light the same receivers into one stratum each, groups that light none into the last.
std::vector<std::uint8_t> strataOf(const Shares& shares)
{
  std::vector<int> order(static_cast<std::size_t>(shares.groups));
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> squares;
  for (int g = 0; g < shares.groups; ++g)
    squares.push_back(shares.squares(g));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return squares[a] > squares[b]; });
  std::vector<std::uint8_t> strata(order.size());
  std::vector<std::vector<double>> sums;  // over the groups of a stratum, per receiver
  for (const int g : order)
  {
    if (!(squares[g] > 0))
    {
      strata[g] = mostStrata;
      continue;
    }
    std::size_t best = sums.size();
    double closest = sums.size() < mostStrata ? alike : -1;
    for (std::size_t s = 0; s < sums.size(); ++s)
    {
      double product = 0, square = 0;
      for (std::size_t r = 0; r < shares.receivers; ++r)
      {
        product += sums[s][r] * shares.at(r, g);
        square += sums[s][r] * sums[s][r];
      }
      const double cosine = product / std::sqrt(square * squares[g]);
      if (cosine > closest)
      {
        closest = cosine;
        best = s;
      }
    }
    if (best == sums.size())
      sums.emplace_back(shares.receivers, 0.0);
    for (std::size_t r = 0; r < shares.receivers; ++r)
      sums[best][r] += shares.at(r, g);
    strata[g] = static_cast<std::uint8_t>(best);
  }
  return strata;
}

std::string percent(double share)
{
  std::ostringstream text;
  text.precision(3);
  text << 100 * share << " %";
  return text.str();
}

// Each emitter's factor, and the strata of their groups.
Emission::Preference preferenceFor(const EmitterGroups& groups, const std::vector<double>& p,
                                   const std::vector<double>& ofFlux, const std::vector<std::uint8_t>& strata)
{
  Emission::Preference preference;
  preference.factors.assign(groups.of.size(), 1);
  preference.strata.assign(groups.of.size(), 0);
  std::size_t preferred = 0, lit = 0;
  double flux = 0, chosen = 0;
  std::vector<bool> favoured(p.size());
  for (std::size_t g = 0; g < p.size(); ++g)
    if ((favoured[g] = p[g] > ofFlux[g]))
    {
      flux += ofFlux[g];
      chosen += p[g];
    }
  for (std::size_t i = 0; i < groups.of.size(); ++i)
  {
    const int g = groups.of[i];
    if (g < 0)
      continue;
    preference.factors[i] = p[g] / ofFlux[g];
    preference.strata[i] = strata[g];
    ++lit;
    preferred += favoured[g];
  }
  preference.choice = percent(chosen) + " of the trajectories from " + std::to_string(preferred) + " of " +
                      std::to_string(lit) + " emitters";
  preference.reason = "by a pilot these light the receivers; they have " + percent(flux) +
                      " of the flux, and all others " + "keep a tenth of their share";
  return preference;
}
// Prefers emitters where that pays.
void chooseEmitters(const Scene& scene, const std::vector<Sensor>& sensors, const Walks& walks, Emission& emission)
{
  const EmitterGroups groups = groupEmitters(scene, emission);
  if (groups.count < 2 || emission.hasSky())
    return;
  std::vector<double> ofFlux(static_cast<std::size_t>(groups.count));
  for (std::size_t i = 0; i < groups.of.size(); ++i)
    if (groups.of[i] >= 0)
      ofFlux[groups.of[i]] += emission.flux(i) / emission.totalFlux();

  // As many trajectories from every group, each in a stratum of its own.
  const std::vector<double> even(ofFlux.size(), 1.0 / groups.count);
  std::vector<std::uint8_t> own(ofFlux.size());
  std::iota(own.begin(), own.end(), std::uint8_t{0});
  Emission pilot(scene);
  pilot.prefer(preferenceFor(groups, even, ofFlux, own));
  Shares first = runPilot(scene, pilot, walks, 0, groups.count, sensors);
  const Shares second = runPilot(scene, pilot, walks, 1, groups.count, sensors);
  const double before = variance(first, ofFlux) + variance(second, ofFlux);
  const double after = variance(first, probabilities(second, ofFlux)) + variance(second, probabilities(first, ofFlux));
  if (!(after < worthwhile * before))
    return;
  for (std::size_t i = 0; i < first.value.size(); ++i)
    first.value[i] = (first.value[i] + second.value[i]) / 2;
  emission.prefer(preferenceFor(groups, probabilities(first, ofFlux), ofFlux, strataOf(first)));
}
}  // namespace

Emission makeEmission(const Scene& scene, const Receivers& receivers, const Settings& settings)
{
  Emission emission(scene, settings.openings);
  if (!settings.uses(Technique::Guiding) || settings.method == Method::Direct || receivers.points.empty() ||
      !(emission.totalFlux() > 0))
    return emission;
  const std::vector<Sensor> sensors = someSensors(scene, receivers);
  chooseEmitters(scene, sensors, settings.walks(), emission);
  emission.send(findPortals(scene, emission, sensors, settings.walks()));
  return emission;
}

void addEmissionAudit(const Emission& emission, std::vector<AuditLine>& lines)
{
  if (emission.isGuided())
    lines.push_back({"trajectories", emission.preference().choice, emission.preference().reason});
  if (!emission.portals().any())
    return;
  double area = 0;
  for (const Portal& portal : emission.portals().all())
    area += portal.area;
  std::ostringstream text;
  text << "of " << std::setprecision(3) << 1e4 * area
       << " cm2; most of what the receivers see is lit through them alone";
  lines.push_back({"openings", std::to_string(emission.portals().all().size()) + " small", text.str()});
}
}  // namespace kalos
