// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for the parsers of IES and EULUMDAT files: an error or light, never anything else.
#include <cstdlib>

#include "photometry/PhotometricFile.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  kalos::PhotometryOptions options;
  options.findTilt = [](const std::string&) { return std::optional<std::string>("1 2 0 90 1 0.5"); };
  try
  {
    const auto file = kalos::parsePhotometry(std::string(reinterpret_cast<const char*>(data), size), options);
    const kalos::CandelaTable& table = file.table;
    if (!(table.flux() > 0) || !std::isfinite(table.flux()) || !(table.upwardFlux() <= 1.001 * table.flux()))
      std::abort();
    for (double u : {0.0, 0.3, 0.999999})
    {
      const kalos::Vec3 d = table.sample(u, 1 - u - 1e-9);
      if (!(std::abs(kalos::length(d) - 1) < 1e-9) || !(table.intensity(d) >= 0))
        std::abort();
    }
    if (!(file.tiltFactor(45) >= 0))
      std::abort();
  }
  catch (const kalos::PhotometryError&)
  {
  }
  return 0;
}
