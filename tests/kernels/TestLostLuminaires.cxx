// SPDX-License-Identifier: BSD-3-Clause
// Luminaires from which no receiver gets light are named, and what encloses them; those round a corner are not.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/quantities/LostLuminaires.h"

using namespace kalos;

namespace
{
SceneDescription room()
{
  SceneDescription d;
  const auto grey = rooms::addMaterial(d, 0.5);
  rooms::addBox(d, {0, 0, 0}, {4, 4, 3}, grey, true);
  rooms::addBox(d, {0.5, 0.5, 0.1}, {1, 1, 1}, grey, false);   // closed
  rooms::addQuad(d, {2, 0, 0}, {0, 3.5, 0}, {0, 0, 3}, grey);  // a screen with a way round it
  d.surfaceNames = {"room", "box", "screen"};
  d.triangleSurface.assign(12, 0);
  d.triangleSurface.resize(24, 1);
  d.triangleSurface.resize(26, 2);
  return d;
}

void addLamp(SceneDescription& d, const std::string& name, const Vec3& p, const Vec3& axis)
{
  Luminaire lamp;
  lamp.position = p;
  lamp.axis = axis;
  lamp.flux = 1000;
  d.luminaires.push_back(lamp);
  d.luminaireNames.push_back(name);
}

std::vector<AuditLine> found(const SceneDescription& d)
{
  Receivers r;
  for (const double y : {0.5, 2.0})
  {
    r.points.push_back({3, y, 0.8});
    r.normals.push_back({0, 0, 1});
  }
  return findLostLuminaires(Scene(d), r, {1, 1});
}
}  // namespace

TEST(LostLuminaires, AreNamedWithWhatEnclosesThem)
{
  SceneDescription d = room();
  addLamp(d, "good", {3, 3, 2.9}, {0, 0, -1});
  addLamp(d, "over", {3, 3, 3.05}, {0, 0, -1});
  addLamp(d, "housed", {1, 1, 0.5}, {0, 0, -1});
  addLamp(d, "away", {3, 3, 3.05}, {0, 0, 1});
  const std::vector<AuditLine> lines = found(d);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].choice, "no light of luminaire over gets to a receiver");
  EXPECT_NE(lines[0].reason.find("of 32 of its rays end on surface room"), std::string::npos) << lines[0].reason;
  EXPECT_EQ(lines[1].choice, "no light of luminaire housed gets to a receiver");
  EXPECT_EQ(lines[1].reason.find("32 of 32 of its rays end on surface box"), 0u) << lines[1].reason;
  EXPECT_EQ(lines[2].reason, "it shines away from all surfaces");
  EXPECT_EQ(lines[2].subject, "warning");
}

// No receiver has light in sight: in the room the lamp is to blame, under its floor and in its box the receivers are.
TEST(LostLuminaires, ReceiversOutsideAreToBlameThemselves)
{
  for (const bool inside : {true, false})
  {
    SceneDescription d = room();
    addLamp(d, "lamp", {3, 3, inside ? 3.05 : 2.5}, {0, 0, -1});
    Receivers r;
    r.points = {inside ? Vec3{3, 2, 1} : Vec3{3, 2, -1}, inside ? Vec3{3, 1, 1} : Vec3{1, 1, 0.6}};
    r.normals = {{0, 0, 1}, {0, 0, 1}};
    EXPECT_EQ(findLostLuminaires(Scene(d), r, {0, 0}).size(), inside ? 1u : 0u);
  }
}

TEST(LostLuminaires, RoundACornerAreNotLost)
{
  SceneDescription d = room();
  rooms::addQuad(d, {1.6, 1, 0}, {0, 3, 0}, {0, 0, 3}, 0);  // a second screen: light comes by a corridor of two turns
  d.triangleSurface.resize(d.triangles.size(), 2);
  addLamp(d, "round the corner", {0.3, 3.2, 2.5}, {0, 0, -1});
  addLamp(d, "flush", {3, 3, 3}, {0, 0, -1});
  addLamp(d, "uplight", {1, 3, 1}, {0, 0, 1});
  EXPECT_TRUE(found(d).empty());
}

TEST(LostLuminaires, AfterEightTheSearchEnds)
{
  SceneDescription d = room();
  d.luminaireNames.clear();
  for (int i = 0; i < 20; ++i)
    addLamp(d, "", {1, 1, 0.5}, {0, 0, -1});
  const std::vector<AuditLine> lines = found(d);
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[7].choice, "no light of luminaire number 7 gets to a receiver");
}
