// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Fingerprint.h"

#include <cstring>

namespace kalos
{
void Fingerprint::add(double value)
{
  std::uint64_t word;
  std::memcpy(&word, &value, sizeof word);
  this->add(word);
}

void Fingerprint::add(const Vec3& v)
{
  for (const double x : {v.x, v.y, v.z})
    this->add(x);
}

void Fingerprint::add(const void* bytes, std::size_t size)
{
  const char* next = static_cast<const char*>(bytes);
  for (std::size_t left = size; left > 0;)
  {
    std::uint64_t word = 0;
    const std::size_t part = left < sizeof word ? left : sizeof word;
    std::memcpy(&word, next, part);
    this->add(word);
    next += part;
    left -= part;
  }
  this->add(static_cast<std::uint64_t>(size));
}

namespace
{
void addMaterial(Fingerprint& sum, const Material& m, int bands)
{
  for (int b = 0; b < bands; ++b)
  {
    sum.add(m.reflectance[b]);
    sum.add(m.exitance[b]);
  }
  for (const double x : {m.specular, m.roughness, m.mirror})
    sum.add(x);
  sum.add(m.glass ? m.glass->normalTransmittance() : 0);
  sum.add(m.glass ? m.glass->refractiveIndex() : 0);
}

void addLuminaire(Fingerprint& sum, const Luminaire& l)
{
  for (const Vec3& v : {l.position, l.axis, l.sideU, l.sideV, l.up})
    sum.add(v);
  sum.add(l.flux);
  sum.add(static_cast<std::uint64_t>(l.distribution));
  if (!l.table)
    return;
  for (const std::vector<double>* values : {&l.table->planes(), &l.table->angles(), &l.table->candela()})
    sum.add(values->data(), values->size() * sizeof(double));
  sum.add(static_cast<std::uint64_t>(l.table->pole()));
}

// By its values in many directions, whatever it is made from.
void addSky(Fingerprint& sum, const Sky& sky)
{
  constexpr int rows = 24, columns = 48;
  for (int i = 0; i < rows * columns; ++i)
  {
    const double z = 1 - 2 * (i / columns + 0.5) / rows, turn = 2 * pi * (i % columns) / columns;
    const double s = std::sqrt(1 - z * z);
    sum.add(sky.luminance({s * std::cos(turn), s * std::sin(turn), z}));
  }
  sum.add(sky.sun());
  sum.add(sky.sunIlluminance());
}
}  // namespace

void Fingerprint::add(const SceneDescription& scene)
{
  this->add(static_cast<std::uint64_t>(scene.bands));
  for (const Vec3& p : scene.points)
    this->add(p);
  this->add(scene.triangles.data(), scene.triangles.size() * sizeof(Triangle));
  this->add(scene.triangleMaterial.data(), scene.triangleMaterial.size() * sizeof(std::uint32_t));
  for (const Material& m : scene.materials)
    addMaterial(*this, m, scene.bands);
  for (const Luminaire& l : scene.luminaires)
    addLuminaire(*this, l);
  if (scene.sky)
    addSky(*this, *scene.sky);
}
}  // namespace kalos
