// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/quantities/LuminanceImage.h"

#include <stdexcept>
#include "estimator/control/Receivers.h"

#include "estimator/direct/DirectLight.h"
#include "estimator/solve/Solver.h"
#include "sampling/Sobol.h"

namespace kalos
{
namespace
{
constexpr int mostPixelSamples = 256;

void check(const Camera& c)
{
  auto require = [](bool condition, const char* message) {
    if (!condition)
      throw std::invalid_argument(message);
  };
  require(isFinite(c.position) && isFinite(c.target) && isFinite(c.up), "camera: coordinates must be finite");
  require(c.fieldOfView > 0 && c.fieldOfView < 180, "camera: the field of view must lie between 0 and 180 degrees");
  require(c.width > 0 && c.height > 0, "camera: the resolution must be at least 1 x 1");
  require(c.pixelSamples > 0 && c.pixelSamples <= mostPixelSamples, "camera: pixel_samples must lie between 1 and 256");
  require(length(c.target - c.position) > 0, "camera: position and target must differ");
  require(length(cross(c.target - c.position, c.up)) > 1e-9 * length(c.target - c.position) * length(c.up),
          "camera: up must not be parallel to the line of sight");
}

// Directions of the lines of sight through the pixels.
class Lens
{
public:
  explicit Lens(const Camera& camera)
      : Forward(normalized(camera.target - camera.position)),
        Right(normalized(cross(this->Forward, camera.up))),
        Up(cross(this->Right, this->Forward)),
        Width(camera.width),
        Height(camera.height),
        HalfHeight(std::tan(camera.fieldOfView * pi / 360))
  {
  }

  // Through the place (u, v) in a pixel, in [0,1).
  Vec3 direction(std::size_t pixel, double u, double v) const
  {
    const std::size_t columns = static_cast<std::size_t>(this->Width), column = pixel % columns, row = pixel / columns;
    const double x =
        (2 * (static_cast<double>(column) + u) / this->Width - 1) * this->HalfHeight * this->Width / this->Height;
    const double y = (2 * (static_cast<double>(row) + v) / this->Height - 1) * this->HalfHeight;
    return normalized(this->Forward + x * this->Right + y * this->Up);
  }

private:
  Vec3 Forward, Right, Up;
  int Width, Height;
  double HalfHeight;
};

// The surface points seen by the camera, as receivers weighted by pixel.
class LinesOfSight
{
public:
  LinesOfSight(const Scene& scene, const Camera& camera) : Scene_(scene), Luminaires(scene, false, false)
  {
    const std::size_t pixels = static_cast<std::size_t>(camera.width) * camera.height;
    this->Emitted.bands = scene.bands();
    this->Emitted.luminance.assign(pixels, 0);
    this->Emitted.standardError.assign(pixels, 0);
    this->Emitted.luminanceBands.assign(pixels * scene.bands(), 0);
    this->Emitted.trusted.assign(pixels, 1);
    const Lens lens(camera);
    const Vec3 eye = camera.position - scene.origin();
    const std::vector<char> atEdge = this->findEdges(camera, lens, eye);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const int samples = atEdge[i] ? camera.pixelSamples : 1;
      for (int k = 0; k < samples; ++k)
      {
        double u = 0.5, v = 0.5;
        if (samples > 1)
          sobolPoint(pixelPattern, static_cast<std::uint32_t>(k), u, v);
        this->follow(i, eye, lens.direction(i, u, v), 1.0 / samples);
      }
    }
  }

  const Receivers& receivers() const { return this->Seen; }

  // The image: exitance seen in the pixels, plus the reflected estimates at the receivers.
  LuminanceResult reflect(const Result& estimate) const
  {
    LuminanceResult image = this->Emitted;
    image.estimate = estimate;
    if (estimate.trajectories == 0)
      return image;
    const int bands = this->Scene_.bands();
    for (std::size_t k = 0; k < this->Pixel.size(); ++k)
    {
      Bands luminance{};
      for (int b = 0; b < bands; ++b)
        luminance[b] = this->Weight[k][b] / pi * estimate.illuminanceBands[k * bands + b];
      for (int b = 0; b < bands; ++b)
        image.luminanceBands[this->Pixel[k] * bands + b] += luminance[b];
      if (!estimate.trusted[k])
        image.trusted[this->Pixel[k]] = 0;
      // Bands and mirror images share the trajectories: they fluctuate together.
      if (estimate.illuminance[k] > 0)
        image.standardError[this->Pixel[k]] +=
            estimate.standardError[k] / estimate.illuminance[k] * photometric(luminance, bands);
    }
    for (std::size_t i = 0; i < image.luminance.size(); ++i)
      image.luminance[i] = photometric(&image.luminanceBands[i * bands], bands);
    return image;
  }

private:
  static constexpr int mirrorsFollowed = 8;  // gather rays follow further ones
  static constexpr std::uint64_t pixelPattern = 0x706978656c;

  // What a line of sight sees.
  struct Sight
  {
    SurfacePoint first;
    std::uint64_t materials = 0;  // a hash of all that it meets by mirrors
  };
  Sight look(const Vec3& eye, Vec3 direction) const
  {
    Sight sight;
    SurfacePoint y = sight.first = this->Scene_.trace(eye, direction);
    for (int mirrors = 0; y.valid; ++mirrors)
    {
      const Material& material = this->Scene_.material(y.triangle);
      sight.materials = mixBits(sight.materials + this->Scene_.data().triangleMaterial[y.triangle] + 1);
      if (!(material.mirror > 0) || mirrors == mirrorsFollowed)
        break;
      direction = reflected(-direction, y.normal);
      y = this->Scene_.trace(this->Scene_.anchor(y), direction);
    }
    return sight;
  }

  static bool isEdge(const Sight& a, const Sight& b)
  {
    constexpr double sameNormal = 0.98, step = 0.2;
    if (a.first.valid != b.first.valid || a.materials != b.materials)
      return true;
    if (!a.first.valid)
      return false;
    const Vec3 way = b.first.position - a.first.position;
    return dot(a.first.normal, b.first.normal) < sameNormal || std::abs(dot(way, a.first.normal)) > step * length(way);
  }

  // Whether each pixel differs from one of those around it.
  std::vector<char> findEdges(const Camera& camera, const Lens& lens, const Vec3& eye) const
  {
    const int width = camera.width, height = camera.height;
    std::vector<char> found(static_cast<std::size_t>(width) * height, 0);
    if (camera.pixelSamples == 1)
      return found;
    std::vector<Sight> sights(found.size());
    for (std::size_t i = 0; i < sights.size(); ++i)
      sights[i] = this->look(eye, lens.direction(i, 0.5, 0.5));
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        for (int r = std::max(0, row - 1); r <= std::min(height - 1, row + 1); ++r)
          for (int c = std::max(0, column - 1); c <= std::min(width - 1, column + 1); ++c)
            if (isEdge(sights[static_cast<std::size_t>(row) * width + column],
                       sights[static_cast<std::size_t>(r) * width + c]))
              found[static_cast<std::size_t>(row) * width + column] = 1;
    return found;
  }

  void follow(std::size_t pixel, const Vec3& eye, Vec3 direction, double weight)
  {
    const int bands = this->Scene_.bands();
    SurfacePoint y = this->Scene_.trace(eye, direction);
    for (int mirrors = 0; y.valid; ++mirrors)
    {
      const Material& material = this->Scene_.material(y.triangle);
      if (y.front)
        for (int b = 0; b < bands; ++b)
          this->Emitted.luminanceBands[pixel * bands + b] += weight * material.exitance[b] / pi;
      const bool last = material.mirror > 0 && mirrors == mirrorsFollowed;
      this->add(pixel, y, -direction, weight, last);
      if (!(material.mirror > 0) || last)
        return;
      weight *= material.mirror;
      direction = reflected(-direction, y.normal);
      const RayAnchor from = this->Scene_.anchor(y);
      y = this->Scene_.trace(from, direction);
      Bands seen{};
      this->Luminaires.addSeen(from.lifted(), direction, y, uniformBands(weight / pi), seen.data());
      for (int b = 0; b < bands; ++b)
        this->Emitted.luminanceBands[pixel * bands + b] += seen[b];
    }
  }

  void add(std::size_t pixel, const SurfacePoint& y, const Vec3& outgoing, double weight, bool withMirror)
  {
    const Brdf& brdf = this->Scene_.brdf(y.triangle);
    const bool lambertian = brdf.material().specular == 0 && !withMirror;
    Bands bands = uniformBands(weight);
    if (lambertian)
      for (int b = 0; b < this->Scene_.bands(); ++b)
        bands[b] *= brdf.material().reflectance[b];
    if (!(photometric(bands, this->Scene_.bands()) > 0))
      return;
    this->Seen.points.push_back(y.position + this->Scene_.origin());
    this->Seen.normals.push_back(y.normal);
    this->Seen.brdfs.push_back(lambertian ? nullptr : &brdf);
    this->Seen.outgoing.push_back(outgoing);
    this->Seen.followsMirror.push_back(withMirror);
    this->Pixel.push_back(pixel);
    this->Weight.push_back(bands);
  }

  const Scene& Scene_;
  LuminanceResult Emitted;  // directly seen exitance; only its bands are used
  DirectLight Luminaires;
  Receivers Seen;
  std::vector<std::size_t> Pixel;  // of each receiver
  std::vector<Bands> Weight;       // from pi times its estimate to the pixel's luminance
};
}  // namespace

LuminanceResult solveLuminance(const Scene& scene, const Camera& camera, const Settings& settings,
                               const Progress& progress, const ImageSnapshot& snapshot)
{
  constexpr long long trajectoriesPerPixel = 1024;
  check(camera);
  const LinesOfSight lines(scene, camera);
  Settings effort = settings;
  if (effort.trajectories == 0 && effort.relativeError == 0 && effort.seconds == 0)
    effort.trajectories = trajectoriesPerPixel;
  Snapshot show;
  if (snapshot)
    show = [&](const Result& soFar) { snapshot(lines.reflect(soFar)); };
  return lines.reflect(solve(scene, lines.receivers(), effort, progress, show));
}
}  // namespace kalos
