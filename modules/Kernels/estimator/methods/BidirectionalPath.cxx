// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/BidirectionalPath.h"

namespace kalos
{
double emissionDensity(const Luminaire* luminaire, const Vec3& n, const Vec3& direction)
{
  return luminaire ? intensity(*luminaire, direction) / luminaire->flux : std::max(0.0, dot(n, direction)) / pi;
}

JoinedPath::JoinedPath(const Scene& scene, const Emission& emission, const Sensor& receiver,
                       const std::vector<PathNode>& nodes, std::size_t m, const LightHalf& light, std::size_t surfaces,
                       bool hit)
    : Scene_(scene),
      Source(emission),
      Receiver(receiver),
      Lamp(hit ? nullptr : light.start.luminaire),
      Connection(m),
      Surfaces(hit ? m - 1 : m + surfaces),
      Meets(hit || light.start.onSurface)
{
  this->Nodes.push_back({receiver.position, receiver.normal, nullptr, m > 0 && nodes[0].byMirror});
  for (std::size_t i = 0; i < m; ++i)
    this->Nodes.push_back({nodes[i].anchor.point, nodes[i].anchor.normal, nodes[i].brdf, i + 1 < m && nodes[i].mirror});
  if (hit)
  {
    this->Triangle = nodes[m - 1].triangle;
    return;
  }
  for (std::size_t i = surfaces; i-- > 0;)
  {
    const PathNode& node = light.nodes[i];
    this->Nodes.push_back({node.anchor.point, node.anchor.normal, node.brdf, i + 1 < surfaces && node.mirror});
  }
  this->Nodes.push_back({light.start.anchor.point, light.start.anchor.normal, nullptr, false});
  this->Triangle = light.start.triangle;
}

double JoinedPath::perArea(std::size_t from, std::size_t to, double perSteradian) const
{
  const Vec3 d = this->Nodes[to].position - this->Nodes[from].position;
  const double squared = dot(d, d);
  return squared > 0 ? perSteradian * absDot(d, this->Nodes[to].normal) / (squared * std::sqrt(squared)) : 0;
}

double JoinedPath::density(std::size_t at, std::size_t before, std::size_t to) const
{
  const Node& node = this->Nodes[at];
  if (node.mirror)
    return 1;  // the delta functions of both directions cancel
  const Vec3 wo = normalized(this->Nodes[before].position - node.position);
  const Vec3 wi = normalized(this->Nodes[to].position - node.position);
  return this->perArea(at, to, node.brdf->density(node.normal, wo, wi, uniformBands(1)));
}

double JoinedPath::fromReceiver(std::size_t k) const
{
  if (k > 1)
    return this->density(k - 1, k - 2, k);
  if (this->Nodes[0].mirror)
    return 1;
  const Vec3 direction = normalized(this->Nodes[1].position - this->Nodes[0].position);
  return this->perArea(0, 1, gatherDensity(this->Receiver, direction));
}

double JoinedPath::fromLight(std::size_t k) const
{
  if (k < this->Surfaces)
    return this->density(k + 1, k + 2, k);
  const Node& emitter = this->Nodes[k + 1];
  const Vec3 direction = normalized(this->Nodes[k].position - emitter.position);
  return this->perArea(k + 1, k, emissionDensity(this->Lamp, emitter.normal, direction));
}

bool JoinedPath::joins(std::size_t m) const
{
  if (m > this->Surfaces)
    return this->Meets;
  return !this->Nodes[m].mirror && !this->Nodes[m + 1].mirror;
}

bool JoinedPath::isChosen(int only) const
{
  std::size_t chosen = this->Surfaces + 1;  // meeting a mesh is what is left where nothing joins
  for (std::size_t m = 0; m <= this->Surfaces; ++m)
    if (this->joins(m) && (chosen > this->Surfaces || m < static_cast<std::size_t>(only)))
      chosen = m;
  return chosen == this->Connection;
}

double JoinedPath::share(int only) const
{
  if (only > 0)
    return this->isChosen(only);
  // P_m is the product of d_R over p_1 ... p_m and of d_L over the others, each pair scaled to a sum of one.
  const std::size_t last = this->Meets ? this->Surfaces + 1 : this->Surfaces;
  std::vector<double> product(last + 1, 1);
  for (std::size_t k = 1; k <= last; ++k)
  {
    const double receiver = this->fromReceiver(k);
    const double light = k <= this->Surfaces ? this->fromLight(k) : this->startDensity();
    if (!(receiver + light > 0))
      return 0;
    for (std::size_t m = 0; m <= last; ++m)
      product[m] *= (m < k ? light : receiver) / (receiver + light);
  }
  double sum = 0;
  for (std::size_t m = 0; m <= last; ++m)
    sum += this->joins(m) ? product[m] : 0;
  return sum > 0 ? product[this->Connection] / sum : 0;
}

double JoinedPath::startDensity() const
{
  const Material& material = this->Scene_.material(this->Triangle);
  return photometric(material.exitance, this->Scene_.bands()) / this->Source.totalFlux();
}
}  // namespace kalos
