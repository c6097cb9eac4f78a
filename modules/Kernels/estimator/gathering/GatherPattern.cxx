// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/GatherPattern.h"

#include <algorithm>

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;

// The bits of a before those of b, 16 each: near in this order is near in both.
std::uint32_t interleave(std::uint32_t a, std::uint32_t b)
{
  auto spread = [](std::uint32_t x) {
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
  };
  return spread(a) << 1 | spread(b);
}

void store(const Vec3& v, float* out)
{
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}
}  // namespace

GatherStart::GatherStart(const Vec3& from, const Vec3& normal, std::uint64_t key)
{
  const double angle = 2 * pi * 0x1.0p-32 * static_cast<double>(mixBits(key) >> 32);
  const double c = std::cos(angle), s = std::sin(angle);
  const Frame frame(normal);
  store(from, this->origin);
  store(c * frame.s + s * frame.t, this->u);
  store(c * frame.t - s * frame.s, this->v);
  store(normal, this->n);
}

GatherPattern::GatherPattern(Sampling sampling, std::uint64_t key, long long first, int count) : Count(count)
{
  struct Point
  {
    std::uint32_t height, azimuth, place;
    int k;
  };
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(count) + width);
  const std::uint64_t seeds = mixBits(key);
  for (int k = 0; k < count; ++k)
  {
    const std::uint64_t index = static_cast<std::uint64_t>(first) + static_cast<std::uint64_t>(k);
    std::uint32_t bits[2];
    if (sampling == Sampling::Sobol)
    {
      sobolBits(static_cast<std::uint32_t>(index), 2, bits);
      bits[0] = owenScramble(bits[0], static_cast<std::uint32_t>(seeds));
      bits[1] = owenScramble(bits[1], static_cast<std::uint32_t>(seeds >> 32));
    }
    else
    {
      const std::uint64_t random = mixBits(seeds + index * 0x9e3779b97f4a7c15ull);
      bits[0] = static_cast<std::uint32_t>(random);
      bits[1] = static_cast<std::uint32_t>(random >> 32);
    }
    points.push_back({bits[0], bits[1], interleave(bits[1] >> 16, bits[0] >> 16), k});
  }
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.place != b.place ? a.place < b.place : a.k < b.k; });
  const int padded = (count + width - 1) / width * width;
  points.resize(static_cast<std::size_t>(padded), points.back());
  for (const Point& point : points)
  {
    this->Place.push_back(point.k);
    this->Height.push_back(point.height);
    const double azimuth = 2 * pi * 0x1.0p-32 * point.azimuth;
    this->Cosine.push_back(static_cast<float>(std::cos(azimuth)));
    this->Sine.push_back(static_cast<float>(std::sin(azimuth)));
  }
}

void GatherPattern::rays(const std::vector<GatherStart>& starts, int each, std::uint64_t key, int begin,
                         SegmentPacket& packet) const
{
  const auto shift = static_cast<std::uint32_t>(mixBits(key));
  GatherStart from[width];
  for (int i = 0; i < width; ++i)
    from[i] = starts[std::min<std::size_t>(starts.size() - 1, this->Place[begin + i] / each)];
  for (int i = 0; i < width; ++i)
  {
    // 23 bits and a half: in (0,1), so that no ray lies on the horizon.
    const float h =
        (static_cast<float>(static_cast<std::int32_t>((this->Height[begin + i] ^ shift) >> 9)) + 0.5f) * 0x1.0p-23f;
    const float s = std::sqrt(h), z = std::sqrt(1 - h), x = s * this->Cosine[begin + i], y = s * this->Sine[begin + i];
    packet.ox[i] = from[i].origin[0];
    packet.oy[i] = from[i].origin[1];
    packet.oz[i] = from[i].origin[2];
    packet.dx[i] = x * from[i].u[0] + y * from[i].v[0] + z * from[i].n[0];
    packet.dy[i] = x * from[i].u[1] + y * from[i].v[1] + z * from[i].n[1];
    packet.dz[i] = x * from[i].u[2] + y * from[i].v[2] + z * from[i].n[2];
  }
}
}  // namespace kalos
