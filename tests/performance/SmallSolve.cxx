// SPDX-License-Identifier: BSD-3-Clause
// A small fixed case whose instructions are counted: `SmallSolve METHOD` solves 100 receivers of a room with two boxes
// on one thread, METHOD being the number of a kalos::Method. Exit status 3: not a method of this build.
#include <cstdlib>
#include <stdexcept>
#include <string>
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "estimator/solve/Solver.h"

int main(int count, char** arguments)
{
  using namespace kalos;
  const Scene scene(rooms::furnishedRoom(0.6));

  Receivers floor;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
    {
      floor.points.push_back({0.25 + 0.5 * i, 0.25 + 0.5 * j, 0});
      floor.normals.push_back({0, 0, 1});
    }
  Settings settings;
  settings.method = static_cast<Method>(count > 1 ? std::atoi(arguments[1]) : 0);
  settings.trajectories = 640;
  settings.threads = 1;
  try
  {
    return solve(scene, floor, settings).illuminance.size() == floor.points.size() ? 0 : 1;
  }
  catch (const std::invalid_argument& error)
  {
    return std::string(error.what()).find("available") != std::string::npos ? 3 : 1;
  }
}
