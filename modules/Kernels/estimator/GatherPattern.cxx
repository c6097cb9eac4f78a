// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/GatherPattern.h"

#include <algorithm>

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;

// The axes of a frame, single precision: directions are x u + y v + z n.
struct Axes
{
  float u[3], v[3], n[3];
};

void turn(const std::uint32_t* height, const float* cosine, const float* sine, std::uint32_t shift, const Axes& axes,
          float* __restrict dx, float* __restrict dy, float* __restrict dz)
{
  for (int i = 0; i < width; ++i)
  {
    // 23 bits and a half: in (0,1), so that no ray lies on the horizon.
    const float u = (static_cast<float>(static_cast<std::int32_t>((height[i] ^ shift) >> 9)) + 0.5f) * 0x1.0p-23f;
    const float s = std::sqrt(u), z = std::sqrt(1 - u), x = s * cosine[i], y = s * sine[i];
    dx[i] = x * axes.u[0] + y * axes.v[0] + z * axes.n[0];
    dy[i] = x * axes.u[1] + y * axes.v[1] + z * axes.n[1];
    dz[i] = x * axes.u[2] + y * axes.v[2] + z * axes.n[2];
  }
}

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

GatherPattern::GatherPattern(Sampling sampling, std::uint64_t key, long long first, int count) : Count(count)
{
  struct Point
  {
    std::uint32_t height, azimuth, place;
  };
  std::vector<Point> points;
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
    points.push_back({bits[0], bits[1], interleave(bits[1] >> 16, bits[0] >> 16)});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.place < b.place; });
  const int padded = (count + width - 1) / width * width;
  points.resize(static_cast<std::size_t>(padded), points.back());
  for (const Point& point : points)
  {
    this->Height.push_back(point.height);
    const double azimuth = 2 * pi * 0x1.0p-32 * point.azimuth;
    this->Cosine.push_back(static_cast<float>(std::cos(azimuth)));
    this->Sine.push_back(static_cast<float>(std::sin(azimuth)));
  }
}

void GatherPattern::rays(const Vec3& origin, const Vec3& normal, std::uint64_t key, int begin,
                         SegmentPacket& packet) const
{
  const std::uint64_t random = mixBits(key);
  const double angle = 2 * pi * 0x1.0p-32 * static_cast<double>(random >> 32);
  const double c = std::cos(angle), s = std::sin(angle);
  const Frame frame(normal);
  Axes axes;
  store(c * frame.s + s * frame.t, axes.u);
  store(c * frame.t - s * frame.s, axes.v);
  store(normal, axes.n);
  std::fill_n(packet.ox, width, static_cast<float>(origin.x));
  std::fill_n(packet.oy, width, static_cast<float>(origin.y));
  std::fill_n(packet.oz, width, static_cast<float>(origin.z));
  turn(&this->Height[begin], &this->Cosine[begin], &this->Sine[begin], static_cast<std::uint32_t>(random), axes,
       packet.dx, packet.dy, packet.dz);
}
}  // namespace kalos
