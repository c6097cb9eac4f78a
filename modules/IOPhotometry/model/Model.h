// SPDX-License-Identifier: BSD-3-Clause
/** What a model file (glTF, OBJ) brings: surfaces in parts, lights, cameras, and what had to be approximated. */
#ifndef KalosModel_h
#define KalosModel_h

#include <string>
#include <vector>

#include "../scene/Mesh.h"
#include "../scene/SceneCameras.h"
#include "../scene/SceneNotes.h"

namespace kalos::scene
{
/** A part under a name of its own: a node of a glTF, an object of an OBJ. Every polygon has a material. */
struct ModelPart
{
  std::string Name;
  Mesh Polygons;
};

/** A light of KHR_lights_punctual. */
struct ModelLight
{
  enum class Kind
  {
    Point,    ///< Strength is the intensity, cd
    Spot,     ///< Strength is the intensity in the middle, cd
    Parallel  ///< Strength is the illuminance across the rays, lx
  };

  std::string Name;
  Kind Type = Kind::Point;
  double Strength = 0.0;
  double InnerAngle = 0.0;  ///< of a spot, from the aim to where it begins to fade, rad
  double OuterAngle = 0.0;  ///< of a spot, to where it is dark, rad
  Vector3 Position{};       ///< m
  Vector3 Aim{};            ///< unit vector
};

struct Model
{
  std::vector<ModelPart> Parts;
  std::vector<ModelLight> Lights;
  std::vector<Camera> Cameras;
  Notes Approximations;
};
}  // namespace kalos::scene

#endif
