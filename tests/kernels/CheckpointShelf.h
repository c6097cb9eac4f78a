// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint store in memory, and a solve of several rounds that it keeps.
#ifndef kalos_tests_CheckpointShelf_h
#define kalos_tests_CheckpointShelf_h

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Checkpoint.h"

namespace kalos
{
// Keeps every checkpoint of a solve.
class Shelf : public CheckpointStore
{
public:
  std::string load() override { return this->Given; }
  void save(const std::string& bytes) override { this->Saved.push_back(bytes); }
  std::string name() const override { return "shelf"; }
  double interval() const override { return this->Interval; }

  double Interval = 0;  // s
  std::string Given;
  std::vector<std::string> Saved;
};

inline SceneDescription room()
{
  SceneDescription d = rooms::furnace(0.6, 50);
  d.luminaires = rooms::litRoom(0.6).luminaires;
  return d;
}

inline Receivers points()
{
  Receivers r;
  for (double x : {0.01, 0.6, 2.4, 4.9})
  {
    r.points.push_back({x, 0.6, 0});
    r.normals.push_back({0, 0, 1});
  }
  return r;
}

inline Settings settings(Method method, Shelf& shelf)
{
  Settings s;
  s.method = method;
  s.trajectories = 32 * 700;
  s.epsilon = 0.5;
  s.relativeError = 1e-3;  // not reached: three rounds or more
  s.checkpoint = &shelf;
  return s;
}
}  // namespace kalos

#endif
