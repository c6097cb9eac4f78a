// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/quantities/DarkReceivers.h"

#include <algorithm>
#include <sstream>

#include "estimator/tally/ProbeRays.h"

namespace kalos
{
namespace
{
constexpr double rounding = 1e-12;
constexpr std::size_t mostExamined = 4096, mostEmitters = 64;
constexpr int rays = 32;

// `values`, or so many of them evenly spread.
template <class T>
std::vector<T> thinned(std::vector<T> values, std::size_t most)
{
  if (values.size() <= most)
    return values;
  std::vector<T> some;
  for (std::size_t i = 0; i < most; ++i)
    some.push_back(values[i * values.size() / most]);
  return some;
}

// A point of an emitter.
struct Emitter
{
  RayAnchor anchor;
  bool oneSided = false;  // a triangle, which shines on the side of its normal only
  Vec3 normal;
};

std::vector<Emitter> emitters(const Scene& scene)
{
  std::vector<Emitter> points;
  for (std::size_t i = 0; i < scene.data().luminaires.size(); ++i)
    if (scene.data().luminaires[i].flux > 0)
      points.push_back({scene.luminaireAnchor(i), false, {}});
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
    {
      const Vec3 centre = (1.0 / 3) * (scene.corner(t, 0) + scene.corner(t, 1) + scene.corner(t, 2));
      points.push_back({scene.anchor(t, centre, scene.normal(t)), true, scene.normal(t)});
    }
  return thinned(std::move(points), mostEmitters);
}

bool seesOne(const Scene& scene, const RayAnchor& from, const std::vector<Emitter>& emitters)
{
  return std::any_of(emitters.begin(), emitters.end(), [&](const Emitter& e) {
    const Vec3 d = from.point - e.anchor.point;
    const bool front = !e.oneSided || dot(e.normal, d) > 1e-6 * length(d);
    return front && !scene.rays().occluded(from, e.anchor);
  });
}

bool hasLightInSight(const Scene& scene, const RayAnchor& here, const std::vector<Emitter>& emitters)
{
  if (seesOne(scene, here, emitters))
    return true;
  const Frame frame(here.normal);
  for (int i = 0; i < rays; ++i)
  {
    const SurfacePoint y = scene.trace(here, probeDirection(frame, i));
    if (y.valid ? seesOne(scene, scene.anchor(y), emitters) : scene.data().sky != nullptr)
      return true;
  }
  return false;
}

// The receivers below `rounding` of the largest value.
std::vector<std::size_t> darkOnes(const std::vector<double>& values)
{
  const double dark = rounding * *std::max_element(values.begin(), values.end());
  std::vector<std::size_t> found;
  for (std::size_t r = 0; r < values.size(); ++r)
    if (values[r] <= dark)
      found.push_back(r);
  return found;
}

// The receivers among `some` without light in sight, in their order.
std::vector<std::size_t> cutOffOnes(const Scene& scene, const Receivers& receivers,
                                    const std::vector<std::size_t>& some, const std::vector<Emitter>& shining)
{
  const auto place = [&](std::size_t r) {
    return placeReceiver(scene, receivers.points[r] - scene.origin(), receivers.normals[r]);
  };
  const auto isCutOff = [&](std::size_t r) { return !hasLightInSight(scene, place(r), shining); };
  const auto see = [&](std::size_t a, std::size_t b) { return !scene.rays().occluded(place(a), place(b)); };
  const std::vector<std::size_t> examined = thinned(some, mostExamined);
  std::vector<char> answers;
  for (const std::size_t r : examined)
    answers.push_back(isCutOff(r));
  std::vector<std::size_t> found;
  std::size_t next = 0;  // of the examined ones, the first that is not before r
  for (const std::size_t r : some)
  {
    while (next < examined.size() && examined[next] < r)
      ++next;
    bool is = false;
    if (next < examined.size() && examined[next] == r)
      is = answers[next];
    else if (next > 0 && see(r, examined[next - 1]))
      is = answers[next - 1];
    else if (next < examined.size() && see(r, examined[next]))
      is = answers[next];
    else
      is = isCutOff(r);
    if (is)
      found.push_back(r);
  }
  return found;
}
}  // namespace

DarkReceivers findDarkReceivers(const Scene& scene, const Receivers& receivers, const Result& result)
{
  const std::vector<double>& values = result.illuminance;
  DarkReceivers answer{{}, std::vector<char>(values.size(), 1)};
  if (values.empty())
    return answer;
  const std::vector<std::size_t> found = darkOnes(values);
  const std::vector<Emitter> shining = found.empty() ? std::vector<Emitter>{} : emitters(scene);
  if (shining.empty() && !scene.data().sky)
    return answer;

  const std::vector<std::size_t> cutOff = cutOffOnes(scene, receivers, found, shining);
  for (const std::size_t r : cutOff)
    answer.valid[r] = 0;
  answer.audit = {{"dark receivers", std::to_string(found.size()) + " of " + std::to_string(values.size()),
                   std::to_string(found.size() - cutOff.size()) + " are in full shadow or turned away from the light"}};
  if (!cutOff.empty())
  {
    const Vec3& p = receivers.points[cutOff.front()];
    std::ostringstream reason;
    reason
        << "outside of a closed room, below a floor or inside a solid; statistics leave them out. The first is number "
        << cutOff.front() << " at (" << p.x << ", " << p.y << ", " << p.z << ")";
    answer.audit.push_back(
        {"warning", "receivers with nothing lit in sight: " + std::to_string(cutOff.size()), reason.str()});
  }
  return answer;
}
}  // namespace kalos
