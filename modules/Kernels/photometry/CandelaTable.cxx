// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/CandelaTable.h"

namespace kalos
{
namespace
{
constexpr double degree = pi / 180;

// Integral of (a + b s) sin(from + s) over s in [0, x]; a + b s >= 0 there.
double sineIntegral(double a, double b, double from, double x)
{
  const double constant = 2 * std::sin(from + 0.5 * x) * std::sin(0.5 * x);
  const double linear = 2 * std::cos(from + 0.5 * x) * std::sin(0.5 * x) - x * std::cos(from + x);
  return std::max(0.0, a * constant + b * linear);
}

// Solves sineIntegral(a, b, from, x) = target for x in [0, width]: Newton's steps, kept inside a shrinking bracket.
double invertSineIntegral(double a, double b, double from, double width, double target)
{
  double low = 0, high = width, x = 0.5 * width;
  for (int i = 0; i < 100 && high - low > 1e-15 * width; ++i)
  {
    const double excess = sineIntegral(a, b, from, x) - target;
    (excess > 0 ? high : low) = x;
    const double slope = (a + b * x) * std::sin(from + x);
    const double next = x - excess / slope;
    if (!(next > low && next < high))
      x = 0.5 * (low + high);
    else if (std::abs(next - x) < 1e-15 * width)
      return next;
    else
      x = next;
  }
  return x;
}

// The interval [k, k + 1] of an ascending array that holds x, and how far in. Steps are mostly even: guessing beats
// bisection, and look-ups are what many measured luminaires cost.
std::size_t locate(const std::vector<double>& ascending, double x, double& t)
{
  const std::size_t last = ascending.size() - 2;
  const double guess = (x - ascending.front()) / (ascending.back() - ascending.front()) * static_cast<double>(last + 1);
  std::size_t k = std::min(last, static_cast<std::size_t>(std::max(0.0, guess)));
  while (k < last && ascending[k + 1] <= x)
    ++k;
  while (k > 0 && ascending[k] > x)
    --k;
  t = (x - ascending[k]) / (ascending[k + 1] - ascending[k]);
  return k;
}
}  // namespace

CandelaTable::CandelaTable(std::vector<double> planes, std::vector<double> angles, std::vector<double> candela,
                           Pole pole)
    : Planes(std::move(planes)), Angles(std::move(angles)), Candela(std::move(candela)), SharedPole(pole)
{
  const std::size_t n = this->Angles.size();
  this->Columns.resize(this->Candela.size());
  for (std::size_t p = 0; p < this->Planes.size(); ++p)
    for (std::size_t a = 0; a < n; ++a)
    {
      this->Largest = std::max(this->Largest, this->at(p, a));
      if (a == 0)
        continue;
      const double width = (this->Angles[a] - this->Angles[a - 1]) * degree, low = this->at(p, a - 1);
      this->Columns[p * n + a] = this->Columns[p * n + a - 1] +
                                 sineIntegral(low, (this->at(p, a) - low) / width, this->Angles[a - 1] * degree, width);
    }
  for (std::size_t p = 0; p + 1 < this->Planes.size(); ++p)
  {
    const double width = (this->Planes[p + 1] - this->Planes[p]) * degree;
    this->Flux += 0.5 * width * (this->Columns[p * n + n - 1] + this->Columns[p * n + 2 * n - 1]);
    this->Slabs.push_back(this->Flux);
  }
  this->Upward = this->sumUpward();
}

double CandelaTable::sumUpward() const
{
  // Type B planes turn about the side: beyond 90 deg of them lies the far side.
  const bool aboutAxis = this->SharedPole == Pole::Axis;
  double sum = 0;
  for (std::size_t p = 0; p + 1 < this->Planes.size(); ++p)
    for (std::size_t a = 0; a + 1 < this->Angles.size(); ++a)
    {
      const double end =
          aboutAxis ? this->Angles[a + 1] : std::max(std::abs(this->Planes[p]), std::abs(this->Planes[p + 1]));
      const std::size_t n = this->Angles.size(), i = p * n + a;
      if (end > 90)
        sum += 0.5 * (this->Planes[p + 1] - this->Planes[p]) * degree *
               (this->Columns[i + 1] - this->Columns[i] + this->Columns[i + n + 1] - this->Columns[i + n]);
    }
  return sum;
}

double CandelaTable::intensity(double plane, double angle) const
{
  if (!(angle >= this->Angles.front() && angle <= this->Angles.back()))
    return 0;
  plane -= 360 * std::floor((plane - this->Planes.front()) / 360);
  if (plane > this->Planes.back())
    return 0;
  double s, t;
  const std::size_t p = locate(this->Planes, plane, s), a = locate(this->Angles, angle, t);
  return (1 - s) * ((1 - t) * this->at(p, a) + t * this->at(p, a + 1)) +
         s * ((1 - t) * this->at(p + 1, a) + t * this->at(p + 1, a + 1));
}

double CandelaTable::intensity(const Vec3& d) const
{
  if (this->SharedPole == Pole::Axis)
    return this->intensity(std::atan2(d.y, d.x) / degree, std::atan2(std::sqrt(d.x * d.x + d.y * d.y), d.z) / degree);
  return this->intensity(std::atan2(d.x, d.z) / degree, std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / degree);
}

Vec3 CandelaTable::direction(double plane, double angle) const
{
  const double s = std::sin(angle), x = s * std::cos(plane), y = s * std::sin(plane), z = std::cos(angle);
  return this->SharedPole == Pole::Axis ? Vec3{x, y, z} : Vec3{y, z, x};
}

Vec3 CandelaTable::sample(double u1, double u2) const
{
  // Choose a slab in proportion to its flux, and a plane in it: the density is linear across.
  const std::size_t n = this->Angles.size();
  const double target = u1 * this->Flux;
  const auto found = std::upper_bound(this->Slabs.begin(), this->Slabs.end() - 1, target);
  const std::size_t p = found - this->Slabs.begin();
  const double before = p ? this->Slabs[p - 1] : 0, inSlab = this->Slabs[p] - before;
  const double v = inSlab > 0 ? std::clamp((target - before) / inSlab, 0.0, 1.0) : 0;
  const double* low = &this->Columns[p * n];
  const double* high = low + n;
  const double first = low[n - 1], last = high[n - 1];
  const double root = first + std::sqrt((1 - v) * first * first + v * last * last);
  // Never quite on a plane, which may be dark.
  const double s = std::clamp(root > 0 ? v * (first + last) / root : 0.5, 1e-12, 1 - 1e-12);

  // Choose an interval of angles in that plane, and the angle in it.
  const double all = (1 - s) * first + s * last, wanted = u2 * all;
  std::size_t a = 0, end = n - 1;
  while (end - a > 1)
  {
    const std::size_t middle = (a + end) / 2;
    const double sum = (1 - s) * low[middle] + s * high[middle];
    (sum <= wanted && sum < all ? a : end) = middle;
  }
  const double width = (this->Angles[a + 1] - this->Angles[a]) * degree;
  const double i0 = (1 - s) * this->at(p, a) + s * this->at(p + 1, a);
  const double i1 = (1 - s) * this->at(p, a + 1) + s * this->at(p + 1, a + 1);
  const double rest = wanted - ((1 - s) * low[a] + s * high[a]);
  const double from = this->Angles[a] * degree;
  const double x = invertSineIntegral(i0, (i1 - i0) / width, from, width, rest);
  const double plane = (this->Planes[p] + s * (this->Planes[p + 1] - this->Planes[p])) * degree;
  return this->direction(plane, from + x);
}
}  // namespace kalos
