// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/LuminanceImage.h"

#include <stdexcept>

#include "estimator/Solver.h"

namespace kalos
{
namespace
{
void check(const Camera& c)
{
  auto require = [](bool condition, const char* message)
  {
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
}  // namespace

LuminanceResult solveLuminance(const Scene& scene, const Camera& camera, const Settings& settings,
                               const Progress& progress)
{
  check(camera);
  const int bands = scene.bands();
  const std::size_t pixels = static_cast<std::size_t>(camera.width) * camera.height;
  LuminanceResult image;
  image.bands = bands;
  image.luminance.assign(pixels, 0);
  image.standardError.assign(pixels, 0);
  image.luminanceBands.assign(pixels * bands, 0);

  // Find what each pixel sees.
  Receivers seen;
  std::vector<std::size_t> pixelOf;
  std::vector<std::uint32_t> triangleOf;
  const Lens lens(camera);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const Vec3 direction = lens.direction(static_cast<int>(i % camera.width), static_cast<int>(i / camera.width));
    const SurfacePoint y = scene.trace(camera.position - scene.origin(), direction);
    if (!y.valid)
      continue;
    seen.points.push_back(y.position + scene.origin());
    seen.normals.push_back(y.normal);
    pixelOf.push_back(i);
    triangleOf.push_back(y.triangle);
    if (y.front)
      for (int b = 0; b < bands; ++b)
        image.luminanceBands[i * bands + b] = scene.material(y.triangle).exitance[b] / pi;
  }

  // Estimate the illuminance there, and reflect it towards the camera.
  image.estimate = solve(scene, seen, settings, progress);
  if (image.estimate.aborted)
    return image;
  for (std::size_t k = 0; k < pixelOf.size(); ++k)
  {
    const std::size_t i = pixelOf[k];
    const Bands& reflectance = scene.material(triangleOf[k]).reflectance;
    for (int b = 0; b < bands; ++b)
      image.luminanceBands[i * bands + b] += reflectance[b] / pi * image.estimate.illuminanceBands[k * bands + b];
    const double mean = image.estimate.illuminance[k];
    const double share = mean > 0 ? image.estimate.standardError[k] / mean : 0;
    double reflected = 0;
    for (int b = 0; b < bands; ++b)
      reflected += bandShare(b, bands) * reflectance[b] / pi * image.estimate.illuminanceBands[k * bands + b];
    image.standardError[i] = share * reflected;  // bands share the trajectories, so they fluctuate together
    image.luminance[i] = photometric(&image.luminanceBands[i * bands], bands);
  }
  return image;
}
}  // namespace kalos
