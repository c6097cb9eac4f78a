// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/DirectSimulation.h"

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

namespace kalos
{
DirectSimulation::DirectSimulation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      HalfSide(settings.epsilon > 0 ? settings.epsilon : scene.size() / 200),
      Source(scene, settings.openings),
      Normals(receivers.normals)
{
  for (std::uint32_t i = 0; i < receivers.points.size(); ++i)
  {
    const bool isPoint = i >= receivers.cells.size() || receivers.cells[i].size() < 3;
    const Frame frame(receivers.normals[i]);
    const Vec3 s = this->HalfSide * frame.s, t = this->HalfSide * frame.t, p = receivers.points[i];
    this->addCell(isPoint ? std::vector<Vec3>{p - s - t, p + s - t, p + s + t, p - s + t} : receivers.cells[i], i);
  }
  this->Cells = std::make_unique<RayScene>(this->CellPoints, this->CellTriangles);
}

void DirectSimulation::addCell(const std::vector<Vec3>& corners, std::uint32_t receiver)
{
  const auto first = static_cast<std::uint32_t>(this->CellPoints.size());
  for (const Vec3& corner : corners)
    this->CellPoints.push_back(corner - this->Scene_.origin());
  double area = 0;
  for (std::uint32_t k = 2; k < corners.size(); ++k)
  {
    this->CellTriangles.push_back({first, first + k - 1, first + k});
    this->Owner.push_back(receiver);
    area += 0.5 * length(cross(corners[k - 1] - corners[0], corners[k] - corners[0]));
  }
  this->CellAreas.push_back(area);
}

bool DirectSimulation::prepare(Workers&, Tally&)
{
  return true;
}

bool DirectSimulation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  return workers.forEachReplicate(tally.replicates(), 1, [&](int replicate, std::size_t) {
    std::vector<std::uint32_t> met;
    const EnergySums energy =
        walkTrajectories(this->Scene_, this->Source, this->Settings_.walks(), replicate, first, count,
                         [&](const Segment& segment) { this->score(segment, replicate, met, tally); });
    tally.energy(replicate).add(energy);
  });
}

void DirectSimulation::score(const Segment& segment, int replicate, std::vector<std::uint32_t>& met, Tally& tally) const
{
  met.clear();
  this->Cells->crossings(segment.from, segment.to, [&](std::uint32_t triangle) {
    const std::uint32_t receiver = this->Owner[triangle];
    if (dot(segment.direction, this->Normals[receiver]) < 0)
      met.push_back(receiver);
  });
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());  // a hit on the diagonal counts once
  for (const std::uint32_t receiver : met)
    for (int b = 0; b < tally.bands(); ++b)
    {
      const double e = segment.weight[b] / this->CellAreas[receiver];
      tally.total(receiver, replicate)[b] += e;
      if (segment.first)
        tally.direct(receiver, replicate)[b] += e;
    }
}

std::vector<AuditLine> DirectSimulation::audit() const
{
  return {{"cells", "own polygons, else squares of side " + std::to_string(2 * this->HalfSide) + " m",
           "direct simulation counts the flux that crosses a cell"}};
}
}  // namespace kalos
