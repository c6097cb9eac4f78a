// SPDX-License-Identifier: BSD-3-Clause
// A mirror and a glossy panel for a room of 5 m, upright before two of its walls.
#ifndef kalos_tests_MirrorAndGloss_h
#define kalos_tests_MirrorAndGloss_h

#include "Rooms.h"

namespace rooms
{
/// For rooms with two materials; the panels take the next two.
inline void addMirrorAndGloss(kalos::SceneDescription& room)
{
  kalos::Material mirror, gloss;
  mirror.mirror = 0.8;
  gloss.reflectance = kalos::uniformBands(0.2);
  gloss.specular = 0.5;
  gloss.roughness = 0.4;
  room.materials.push_back(mirror);
  addQuad(room, {0.5, 0.02, 0.5}, {0, 0, 2}, {2, 0, 0}, 2);
  room.materials.push_back(gloss);
  addQuad(room, {4.98, 0.5, 0.5}, {0, 0, 3}, {0, 3, 0}, 3);
}
}  // namespace rooms

#endif
