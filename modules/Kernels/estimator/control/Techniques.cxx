// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/control/Techniques.h"

#include <sstream>
#include <stdexcept>

namespace kalos
{
namespace
{
struct Technique
{
  const char* name;
  bool (*isOff)(const Settings&);
  void (*disable)(Settings&);
};

const Technique techniques[] = {
    {"stratified", [](const Settings& s) { return s.sampling == Sampling::Independent; },
     [](Settings& s) { s.sampling = Sampling::Independent; }},
    {"picked", [](const Settings& s) { return s.shadowEveryPair; }, [](Settings& s) { s.shadowEveryPair = true; }},
    {"convex", [](const Settings& s) { return s.shadowConvexRooms; }, [](Settings& s) { s.shadowConvexRooms = true; }},
    {"near", [](const Settings& s) { return s.gatherEverywhere; }, [](Settings& s) { s.gatherEverywhere = true; }},
    {"paths", [](const Settings& s) { return s.alwaysVertices; }, [](Settings& s) { s.alwaysVertices = true; }},
    {"neighbours", [](const Settings& s) { return s.ownRays; }, [](Settings& s) { s.ownRays = true; }},
    {"effort", [](const Settings& s) { return s.evenEffort; }, [](Settings& s) { s.evenEffort = true; }},
    {"highlights", [](const Settings& s) { return s.vertexHighlights; },
     [](Settings& s) { s.vertexHighlights = true; }},
    {"exact-direct", [](const Settings& s) { return s.sampleDirect; }, [](Settings& s) { s.sampleDirect = true; }},
};
}  // namespace

void disable(const std::string& names, Settings& settings)
{
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');)
  {
    bool known = false;
    std::string all;
    for (const Technique& technique : techniques)
    {
      all += std::string(all.empty() ? "" : ", ") + technique.name;
      if (name == technique.name)
      {
        technique.disable(settings);
        known = true;
      }
    }
    if (!known)
      throw std::invalid_argument("without: '" + name + "' is not a technique, expected some of " + all);
  }
}

std::string disabledTechniques(const Settings& settings)
{
  std::string names;
  for (const Technique& technique : techniques)
    if (technique.isOff(settings))
      names += std::string(names.empty() ? "" : ",") + technique.name;
  return names;
}
}  // namespace kalos
