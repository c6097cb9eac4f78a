// SPDX-License-Identifier: BSD-3-Clause
// Scores that are not finite stop a solve; the energy balance holds and reveals leaks and turned normals; a replicate
// can be played again.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Replay.h"
#include "estimator/solve/Solver.h"
#include "estimator/tally/Tally.h"
#include "statistics/Replicates.h"

using namespace kalos;

namespace
{
Receivers points()
{
  Receivers r;
  for (double x : {0.01, 0.6, 2.4})
  {
    r.points.push_back({x, 0.6, 0});
    r.normals.push_back({0, 0, 1});
  }
  return r;
}

Settings settings(Method method, long long trajectories = 6400)
{
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.method = method;
  s.trajectories = trajectories;
  s.epsilon = 0.5;
  return s;
}

std::string line(const Result& result, const std::string& subject)
{
  std::string found;
  for (const AuditLine& l : result.audit)
    if (l.subject == subject)
      found += l.choice + "; " + l.reason + "\n";
  return found;
}
}  // namespace

// An exitance that single precision does not hold: the flux of the vertices is infinite.
TEST(CheckFinite, ScoresThatAreNoneNameTheirVertex)
{
  SceneDescription d = rooms::furnace(0.6, 1e39);
  const Scene scene(d);
  for (const Method method : {Method::Local, Method::Compensated, Method::Gathered})
    try
    {
      solve(scene, points(), settings(method));
      ADD_FAILURE() << "accepted";
    }
    catch (const std::runtime_error& error)
    {
      const std::string text = error.what();
      EXPECT_EQ(text.find("receiver 0 at (0.01, 0.6, 0): a score of replicate 0 is infinite, negative or not a number: "
                          "trajectory 0, vertex 0 at ("),
                0u)
          << text;
      EXPECT_NE(text.find("carries inf lm"), std::string::npos) << text;
    }
}

TEST(CheckFinite, NegativeScoresMakeAReceiverUnsound)
{
  const Scene scene(rooms::litRoom(0.5));
  Tally tally(scene, 2, 4);
  tally.noteScore(0, 1, 3);
  EXPECT_TRUE(tally.sound(0, 1));
  tally.noteScore(0, 1, -1e-9);
  tally.noteScore(0, 1, 3);
  EXPECT_FALSE(tally.sound(0, 1));
  tally.noteScore(1, 2, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(tally.sound(1, 2));
  *tally.total(1, 0) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(tally.sound(1, 0));
  EXPECT_TRUE(tally.sound(0, 0));
}

TEST(Tally, AScoreStandsOutBeyondThreeTimesTheMedianOfTheReplicates)
{
  const Scene scene(rooms::litRoom(0.5));
  Tally tally(scene, 1, 16);
  for (int replicate = 0; replicate < 16; ++replicate)
    tally.noteScore(0, replicate, replicate < 15 ? 2 : 5.9);
  EXPECT_FALSE(tally.largestStandsOut(0));
  tally.noteScore(0, 3, 6.1);
  EXPECT_TRUE(tally.largestStandsOut(0));
  EXPECT_TRUE(Tally(scene, 1, 7).largestStandsOut(0)) << "too few to tell";
}

// A closed room keeps its light, whatever its materials; all methods count alike.
TEST(EnergyBalance, AClosedRoomAbsorbsEverything)
{
  for (const Method method : {Method::Local, Method::Compensated, Method::Gathered, Method::Direct})
    for (const double rho : {0.3, 0.9})
    {
      SceneDescription d = rooms::litRoom(rho);  // no boxes: what leaves by their undersides is outside the room
      d.materials[0].exitance[0] = 100;
      d.materials[0].reflectance[0] -= 0.2;
      d.materials[0].specular = 0.04;
      d.materials[0].roughness = 0.3;
      d.materials[0].mirror = 0.1;
      const Result result = solve(Scene(d), points(), settings(method));
      // That what is absorbed is what is emitted, within 6 standard errors, is held by the warning that is not there.
      EXPECT_NE(line(result, "energy").find(" % absorbed, 0 % escaped; of 25000 lm"), std::string::npos)
          << line(result, "energy");
      EXPECT_EQ(line(result, "warning"), "");
    }
}

// What leaves by an opening: of an isotropic lamp in the middle of a black cube without a lid a sixth. Binomial, |z| <
// 4.4 (false alarm 1e-5).
TEST(EnergyBalance, AnOpeningLetsOutItsShare)
{
  SceneDescription d = rooms::litRoom(0);
  d.luminaires[0].position = {2.5, 2.5, 2.5};
  d.luminaires[0].distribution = Distribution::Isotropic;
  for (std::size_t t = 0; t < d.triangles.size(); ++t)
    if (d.points[d.triangles[t][0]].z + d.points[d.triangles[t][1]].z + d.points[d.triangles[t][2]].z == 15)
    {
      d.triangles.erase(d.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      d.triangleMaterial.pop_back();
      --t;
    }
  const Result result = solve(Scene(d), points(), settings(Method::Direct, 64000));
  const std::string energy = line(result, "energy");
  const double escaped = std::stod(energy.substr(energy.find(", ") + 2)) / 100;
  EXPECT_NEAR(escaped, 1.0 / 6, 4.4 * std::sqrt(5.0 / 36 / 64000) + 5e-4) << energy;  // three digits are printed
  EXPECT_EQ(line(result, "warning"), "");
}

// A slit of 5 mm along one wall: 0.04 % of the light gets out, and the audit names the surface that it left last.
TEST(EnergyBalance, ALeakIsAWarningWithTheSurface)
{
  SceneDescription d = rooms::litRoom(0.6);
  d.surfaceNames = {"shell", "shelf"};
  d.triangleSurface.assign(d.triangles.size(), 0);
  rooms::addQuad(d, {1, 1, 1}, {0.1, 0, 0}, {0, 0.1, 0}, 0);
  d.triangleSurface.resize(d.triangles.size(), 1);
  for (int i = 0; i < 4; ++i)
    if (d.points[i].x == 5)
      d.points[i].x -= 0.005;  // of the floor
  const Result result = solve(Scene(d), points(), settings(Method::Local, 64000));
  EXPECT_EQ(line(result, "warning").find("surface shell seems to leak; 0.0"), 0u) << line(result, "energy");
}

TEST(EnergyBalance, TurnedNormalsAreWarnings)
{
  SceneDescription d = rooms::litRoom(0.6);
  const auto lamp = rooms::addMaterial(d, 0.1, 5000);
  rooms::addBox(d, {1, 1, 3}, {0.3, 0.3, 0.1}, lamp, true);
  EXPECT_EQ(line(solve(Scene(d), points(), settings(Method::Local, 64000)), "warning"),
            "what is of material 1 shines into itself; its normals may be turned; it emits on their side\n");
  SceneDescription out = rooms::litRoom(0.6);
  rooms::addQuad(out, {1, 1, 6}, {1, 0, 0}, {0, 1, 0}, rooms::addMaterial(out, 0.1, 5000));
  EXPECT_EQ(line(solve(Scene(out), points(), settings(Method::Local, 64000)), "warning"),
            "what is of material 1 shines out of the scene; its normals may be turned; it emits on their side\n");
}

// The mean of all replayed replicates is the illuminance, to the last bit.
TEST(Replay, IsTheReplicateOfTheSolve)
{
  SceneDescription d = rooms::furnace(0.6, 50);
  d.luminaires = rooms::litRoom(0.6).luminaires;
  const Scene scene(d);
  for (const Method method : {Method::Local, Method::SphereExact, Method::Compensated, Method::Gathered, Method::Direct,
                              Method::Paths, Method::PhotonMap})
  {
    const Settings s = settings(method, 3200);
    const Result result = solve(scene, points(), s);
    std::vector<double> estimates;
    for (int p = 0; p < result.replicates; ++p)
    {
      const Replay played = replay(scene, points(), s, 1, p);
      EXPECT_EQ(played.replicates, result.replicates);
      EXPECT_EQ(played.trajectories * played.replicates, result.trajectories);
      double sum = 0;
      for (const RoundScores& round : played.rounds)
        sum += round.sum;
      EXPECT_NEAR(played.fixed + sum / static_cast<double>(played.trajectories), played.estimate,
                  1e-9 * played.estimate);
      estimates.push_back(played.estimate);
    }
    EXPECT_EQ(summarise(estimates.data(), estimates.size()).mean, result.illuminance[1]);
    EXPECT_EQ(summarise(estimates.data(), estimates.size()).standardError, result.standardError[1]);
  }
}

TEST(Replay, RefusesWhatIsNotThere)
{
  const Scene scene(rooms::litRoom(0.6));
  auto message = [&](std::size_t receiver, int replicate, double error) -> std::string {
    Settings s = settings(Method::Local);
    s.relativeError = error;
    try
    {
      replay(scene, points(), s, receiver, replicate);
      return "accepted";
    }
    catch (const std::invalid_argument& refused)
    {
      return refused.what();
    }
  };
  EXPECT_EQ(message(3, 0, 0), "replay: receiver 3 is not there; expected 0 to 2");
  EXPECT_EQ(message(0, 32, 0), "replay: replicate 32 is not there; expected 0 to 31");
  EXPECT_EQ(message(0, 0, 0.1),
            "replay: the solve has a goal, so that its rounds depend on all receivers; expected "
            "only trajectories");
}
