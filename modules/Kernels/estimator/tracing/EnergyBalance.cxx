// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/EnergyBalance.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "statistics/Replicates.h"

namespace kalos
{
namespace
{
constexpr double leastLeak = 2e-5, largestLeak = 1e-3;
constexpr double enoughStarts = 32, manyStarts = 1024;
constexpr double fewestUnseen = 8, leastUnseen = 5e-3;

std::string percent(double share, int digits = 3)
{
  std::ostringstream text;
  text << std::setprecision(digits) << 100 * share << " %";
  return text.str();
}
}  // namespace

void EnergySums::add(const EnergySums& other)
{
  for (std::size_t i = 0; i < this->Values.size() && i < other.Values.size(); ++i)
    this->Values[i] += other.Values[i];
}

void EnergyBalance::exchange(const Ranks& ranks)
{
  ranks.exchange(static_cast<int>(this->Sums.size()), [this](int first, int last, const auto& visit) {
    for (int p = first; p < last; ++p)
      for (double& value : this->Sums[p].values())
        visit(value);
  });
}

void EnergyBalance::persist(Archive& archive)
{
  for (EnergySums& sums : this->Sums)
    archive.array(sums.values());
}

std::vector<AuditLine> EnergyBalance::audit() const
{
  EnergySums all(this->Scene_.surfaces());
  std::vector<double> excess;
  for (EnergySums sums : this->Sums)
  {
    all.add(sums);
    if (sums.emitted() > 0)
      excess.push_back((sums.absorbed() + sums.escaped()) / sums.emitted() - 1);
  }
  if (!(all.emitted() > 0))
    return {};
  const MeanAndError balance = summarise(excess.data(), excess.size());
  const double escaped = all.escaped() / all.emitted();
  std::ostringstream reason;
  reason << "of " << std::setprecision(6) << all.emitted() / all.trajectories()
         << " lm; absorbed and escaped differ from emitted by " << std::showpos << percent(balance.mean, 2)
         << std::noshowpos << " +- " << percent(balance.standardError, 2);
  std::vector<AuditLine> lines{{"energy",
                                percent(all.absorbed() / all.emitted()) + " absorbed, " + percent(escaped) + " escaped",
                                reason.str()}};
  auto warn = [&](const std::string& what, const std::string& expected) {
    lines.push_back({"warning", what, expected});
  };
  if (std::abs(balance.mean) > 6 * balance.standardError + 1e-9)
    warn("light is lost or made", "absorbed and escaped light must add up to the emitted light: " + reason.str());
  std::size_t worst = 0;
  for (std::size_t s = 0; s < this->Scene_.surfaces(); ++s)
  {
    if (all.lastSeen(s) > all.lastSeen(worst))
      worst = s;
    if (all.unseen(s) >= fewestUnseen && all.unseen(s) > leastUnseen * all.checked(s))
      warn(
          this->Scene_.surfaceName(s) + " does not deliver all of its light",
          percent(all.unseen(s) / all.checked(s)) + " of " + std::to_string(std::llround(all.checked(s))) +
              " vertices checked there do not see what their own trajectory went on to hit; expected none: values that "
              "it lights are too low");
    if (all.starts(s) < enoughStarts)
      continue;
    if (all.lost(s) == all.starts(s))
      warn(this->Scene_.surfaceName(s) + " shines out of the scene",
           "its normals may be turned; it emits on their side");
    else if (all.trapped(s) == all.starts(s) && all.starts(s) >= manyStarts && this->Scene_.surfaces() > 1)
      warn(this->Scene_.surfaceName(s) + " shines into itself", "its normals may be turned; it emits on their side");
  }
  if (escaped > leastLeak && escaped < largestLeak && all.lastSeen(worst) > 0 && !this->Scene_.data().sky)
    warn(this->Scene_.surfaceName(worst) + " seems to leak",
         percent(escaped) + " of the light leaves the scene, last seen there; expected none in a closed room");
  return lines;
}
}  // namespace kalos
