// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/Radiosity.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "estimator/tracing/VertexRound.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr double elementsPerRoot = 4;       // of the trajectories
constexpr double trustedDifference = 0.01;  // of the value, between elements and those twice as long
constexpr int comparisonRays = 256;

// Memory that is free, bytes; infinite where the system does not say.
double freeMemory()
{
  std::ifstream table("/proc/meminfo");
  std::string name;
  for (double kilobytes; table >> name >> kilobytes; table.ignore(64, '\n'))
    if (name == "MemAvailable:")
      return 1024 * kilobytes;
  return std::numeric_limits<double>::infinity();
}

long long planned(const Settings& settings)
{
  return settings.trajectories ? settings.trajectories : defaultTrajectories;
}
}  // namespace

Radiosity::Radiosity(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, false),
      Luminaires(scene, false, this->Direct.shadows())
{
  this->refuse();
  if (!(this->Source.totalFlux() > 0) || this->Direct.complete())
    return;
  this->Sides = std::make_unique<LitSides>(scene, this->Source, settings.seed);
  this->findElements();
}

void Radiosity::refuse() const
{
  for (std::uint32_t t = 0; t < this->Scene_.data().triangles.size(); ++t)
    if (!this->Scene_.brdf(t).isLambertian())
      throw std::invalid_argument("method: radiosity knows diffuse surfaces only, and " +
                                  this->Scene_.surfaceName(this->Scene_.surface(t)) +
                                  " is glossy or a mirror; expected compensated or another method");
}

void Radiosity::findElements()
{
  const double wanted = elementsPerRoot * std::sqrt(static_cast<double>(planned(this->Settings_))) /
                        (this->Settings_.own.linear ? RadiositySystem::points : 1);
  this->Length = this->Settings_.epsilon > 0
                     ? this->Settings_.epsilon
                     : RadiosityMesh::lengthFor(this->Scene_, *this->Sides, static_cast<std::size_t>(wanted));
  const std::size_t count = RadiosityMesh::count(this->Scene_, *this->Sides, this->Length);
  const double needed = RadiositySystem::bytes(count, this->Settings_.own.linear), there = freeMemory();
  if (needed > there)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "epsilon: elements of " << this->Length << " m are " << count
         << ", whose form factors need " << needed / 1e9 << " GB, and " << there / 1e9
         << " GB are free; expected longer ones"
         << (this->Settings_.epsilon > 0 ? "" : ", or a mesh of fewer triangles");
    throw std::invalid_argument(text.str());
  }
  this->Mesh = std::make_unique<RadiosityMesh>(this->Scene_, *this->Sides, this->Length);
}

RadiositySystem Radiosity::system(const RadiosityMesh& mesh) const
{
  return RadiositySystem(this->Scene_, mesh, this->Luminaires, this->Settings_.own.linear, this->Direct.shadows());
}

bool Radiosity::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  return this->Direct.prepare(workers, tally) && (!this->Mesh || this->compare(workers, tally.receivers()));
}

// With random numbers that no estimate uses: the same on every rank, and in a solve that goes on.
bool Radiosity::compare(Workers& workers, std::size_t receivers)
{
  // Shorter ones where elements are whole triangles already.
  const bool whole =
      this->Mesh->elements().size() == RadiosityMesh::count(this->Scene_, *this->Sides, 2 * this->Length);
  this->ComparedWith = whole ? "half" : "twice";
  const RadiosityMesh coarse(this->Scene_, *this->Sides, (whole ? 0.5 : 2) * this->Length);
  RadiositySystem fine = this->system(*this->Mesh), rough = this->system(coarse);
  if (!fine.solve(this->Settings_.seed, pilotReplicate, workers) ||
      !rough.solve(this->Settings_.seed, pilotReplicate, workers))
    return false;
  this->Residual = fine.residual();
  this->Iterations = fine.iterations();
  std::vector<double> sum(receivers), off(receivers);
  if (!workers.forEach(receivers, [&](std::size_t r) {
        const int bands = this->Scene_.bands();
        sum[r] = photometric(this->lightAt(r, *this->Mesh, fine, pilotReplicate, 0, comparisonRays).all, bands);
        off[r] = sum[r] - photometric(this->lightAt(r, coarse, rough, pilotReplicate, 0, comparisonRays).all, bands);
      }))
    return false;
  double all = 0, difference = 0, squares = 0;
  for (std::size_t r = 0; r < receivers; ++r)
  {
    all += sum[r];
    difference += off[r];
    squares += off[r] * off[r];
    const double value = sum[r] + this->Direct.illuminance(r);
    this->Difference.push_back(static_cast<float>(value > 0 ? off[r] / value : 0));
  }
  this->MeanDifference = all > 0 ? difference / all : 0;
  this->RmsDifference = all > 0 ? std::sqrt(squares * static_cast<double>(receivers)) / all : 0;
  return true;
}

Radiosity::Reading Radiosity::reading(const RadiosityMesh& mesh, const Sensor& sensor) const
{
  Reading found;
  const double depth = 4 * this->Scene_.contact(sensor.position) + sensor.anchor.lift();
  const SurfacePoint y = this->Scene_.trace(RayAnchor(sensor.position + depth * sensor.normal), -sensor.normal);
  if (!y.valid || !(dot(y.normal, sensor.normal) > 0.7) ||
      dot(sensor.position + depth * sensor.normal - y.position, sensor.normal) > 2 * depth)
    return found;
  found.onElement = mesh.locate(y, found.place);
  return found;
}

Radiosity::Light Radiosity::lightAt(std::size_t r, const RadiosityMesh& mesh, const RadiositySystem& solved,
                                    int replicate, long long first, int rays) const
{
  const Sensor& sensor = this->Direct.sensors()[r];
  const int bands = this->Scene_.bands();
  const bool withMeshes = !this->Direct.exactMeshes(r);
  Light light;
  const Reading read = this->Settings_.own.finalGather ? Reading() : this->reading(mesh, sensor);
  if (read.onElement)
  {
    light.all = solved.reflected(read.place);
    if (withMeshes)
      light.fromMeshes = solved.meshes(read.place);
    for (int b = 0; b < bands; ++b)
      light.all[b] = std::max(0.0, light.all[b]) + light.fromMeshes[b];
    return light;
  }
  const Walks walks = this->Settings_.walks().ofReceiver(r);
  for (int k = 0; k < rays; ++k)
  {
    SampleStream random = walks.stream(replicate, Purpose::Gather, first + k);
    const double u1 = random.next(), u2 = random.next();
    const SurfacePoint y = this->Scene_.trace(sensor.anchor, Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2)));
    RadiosityMesh::Place place;
    if (!y.valid)
      continue;
    const Bands sent = mesh.locate(y, place) ? solved.exitance(place) : Bands{};
    const Material& material = this->Scene_.material(y.triangle);
    for (int b = 0; b < bands; ++b)
    {
      const double own = withMeshes && y.front ? material.exitance[b] : 0;
      light.all[b] += (sent[b] + own) / rays;
      light.fromMeshes[b] += own / rays;
    }
  }
  return light;
}

Pace Radiosity::pace() const
{
  // One solution a round.
  Pace pace;
  pace.multiple = pace.smallest =
      static_cast<int>(std::min<long long>(8192, (planned(this->Settings_) + this->Replicates - 1) / this->Replicates));
  return pace;
}

bool Radiosity::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const auto mine = workers.mine(tally.replicates());
  RadiositySystem solved = this->system(*this->Mesh);
  for (int replicate = mine.first; replicate < mine.last; ++replicate)
  {
    workers.setStep(replicate - mine.first, mine.last - mine.first);
    if (!solved.solve(mixBits(this->Settings_.seed) + static_cast<std::uint64_t>(first), replicate, workers) ||
        !workers.forEach(tally.receivers(), [&](std::size_t r) {
          const Light light = this->lightAt(r, *this->Mesh, solved, replicate, first, count);
          for (int b = 0; b < tally.bands(); ++b)
          {
            tally.total(r, replicate)[b] += count * light.all[b];
            tally.direct(r, replicate)[b] += count * light.fromMeshes[b];
          }
          tally.noteScore(r, replicate, photometric(light.all, tally.bands()));
          this->Direct.score(r, replicate, first, count, tally);
        }))
      return false;
  }
  return true;
}

bool Radiosity::trusts(std::size_t receiver, long long /*trajectories*/) const
{
  return this->Difference.empty() || std::abs(this->Difference[receiver]) <= static_cast<float>(trustedDifference);
}

std::vector<AuditLine> Radiosity::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  if (!this->Mesh)
    return lines;
  const std::size_t count = this->Mesh->elements().size();
  std::ostringstream elements, memory, amount, reason, residual;
  elements << count << (this->Settings_.own.linear ? " linear, " : " constant, ") << std::setprecision(3)
           << this->Length << " m long at most";
  memory << std::setprecision(3) << "form factors take "
         << RadiositySystem::bytes(count, this->Settings_.own.linear) / 1e6 << " MB; " << this->Sides->count()
         << " sides of triangles are lit";
  residual << this->Iterations << " iterations";
  reason << std::setprecision(2) << "Gauss-Seidel; the last one changed no value by more than " << this->Residual
         << " of the largest";
  lines.push_back({"elements", elements.str(), memory.str()});
  lines.push_back({"solution", residual.str(), reason.str()});
  const double mean = 100 * this->MeanDifference, rms = 100 * this->RmsDifference;
  amount << std::showpos << std::setprecision(2) << mean << " +- " << std::noshowpos << std::abs(mean) << " %";
  std::ostringstream rest;
  rest << std::setprecision(2) << "of the indirect light, by comparison with elements " << this->ComparedWith
       << " as long; rms over the receivers " << rms << " %";
  lines.push_back({"discretisation", amount.str(), rest.str()});
  return lines;
}
}  // namespace kalos
