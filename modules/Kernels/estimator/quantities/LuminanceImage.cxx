// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/quantities/LuminanceImage.h"

#include <stdexcept>
#include "estimator/control/Receivers.h"

#include "estimator/direct/DirectLight.h"
#include "estimator/solve/Solver.h"

namespace kalos
{
namespace
{
void check(const Camera& c)
{
  auto require = [](bool condition, const char* message) {
    if (!condition)
      throw std::invalid_argument(message);
  };
  require(isFinite(c.position) && isFinite(c.target) && isFinite(c.up), "camera: coordinates must be finite");
  require(c.fieldOfView > 0 && c.fieldOfView < 180, "camera: the field of view must lie between 0 and 180 degrees");
  require(c.width > 0 && c.height > 0, "camera: the resolution must be at least 1 x 1");
  require(length(c.target - c.position) > 0, "camera: position and target must differ");
  require(length(cross(c.target - c.position, c.up)) > 1e-9 * length(c.target - c.position) * length(c.up),
          "camera: up must not be parallel to the line of sight");
}

// Direction of the line of sight through the centre of a pixel.
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

  Vec3 direction(int column, int row) const
  {
    const double x = (2 * (column + 0.5) / this->Width - 1) * this->HalfHeight * this->Width / this->Height;
    const double y = (2 * (row + 0.5) / this->Height - 1) * this->HalfHeight;
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
    for (std::size_t i = 0; i < pixels; ++i)
      this->follow(i, eye, lens.direction(static_cast<int>(i % camera.width), static_cast<int>(i / camera.width)), 1,
                   0);
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
  static constexpr int mirrorsFollowed = 8;    // gather rays follow further ones
  static constexpr double leastWeight = 1e-4;  // of a reflection in glass that is followed

  // Adds what is seen along a line of sight that `mirrors` mirrors or panes have turned.
  void follow(std::size_t pixel, const RayAnchor& from, const Vec3& direction, double weight, int mirrors)
  {
    const Scene& scene = this->Scene_;
    const SurfacePoint y = scene.trace(from, direction), pane = scene.pane(from, direction, y);
    this->addLights(pixel, from, direction, pane.valid ? pane : y, weight, mirrors > 0);
    if (pane.valid)  // shows what is behind it, and a reflection
    {
      const Glass& glass = *scene.material(pane.triangle).glass;
      const double cosine = dot(direction, pane.normal), back = weight * glass.reflectance(cosine);
      if (mirrors < mirrorsFollowed && back > leastWeight)
        this->follow(pixel, scene.anchor(pane), reflected(-direction, pane.normal), back, mirrors + 1);
      this->follow(pixel, scene.behind(pane), direction, weight * glass.transmittance(cosine), mirrors);
      return;
    }
    if (!y.valid)
      return;
    const Material& material = scene.material(y.triangle);
    const bool last = material.mirror > 0 && mirrors == mirrorsFollowed;
    this->add(pixel, y, -direction, weight, last);
    if (material.mirror > 0 && !last)
      this->follow(pixel, scene.anchor(y), reflected(-direction, y.normal), weight * material.mirror, mirrors + 1);
  }

  // Exitance and sky at the end of a line of sight; behind a mirror the luminous rectangles on its way.
  void addLights(std::size_t pixel, const RayAnchor& from, const Vec3& direction, const SurfacePoint& end,
                 double weight, bool mirrored)
  {
    Bands seen{};
    const auto& sky = this->Scene_.data().sky;
    if (mirrored)
      this->Luminaires.addSeen(from.lifted(), direction, end, uniformBands(weight / pi), seen.data());
    else if (!end.valid && sky)
      seen = uniformBands(weight * sky->luminanceWithSun(direction));
    for (int b = 0; b < this->Scene_.bands(); ++b)
    {
      const double exitance = end.valid && end.front ? this->Scene_.material(end.triangle).exitance[b] : 0;
      this->Emitted.luminanceBands[pixel * this->Scene_.bands() + b] += seen[b] + weight * exitance / pi;
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
