// SPDX-License-Identifier: BSD-3-Clause
/**
 * Every data array that Kalos reads or writes, with its unit. Nothing else in the VTK layer spells an array name.
 *
 * Arrays with "1 or n components" hold one value per band: 1 component is photometric, 3 are linear Rec. 709 red, green
 * and blue, any other n are n bands of equal luminous share. A photometric total weighs the bands by vtkKalos's
 * convention: 1; 0.2126, 0.7152, 0.0722; or 1/n each.
 */
#ifndef vtkKalosArrayNames_h
#define vtkKalosArrayNames_h

namespace vtkKalosArrayNames
{
// Surfaces, cell data of vtkPolyData.
constexpr const char* Reflectance = "Reflectance";  ///< diffuse reflectance [0,1), 1 or n components; required
constexpr const char* Specular = "Specular";        ///< normal-incidence reflectance of the glossy lobe [0,1)
constexpr const char* Roughness = "Roughness";      ///< GGX roughness of the glossy lobe (0,1]
constexpr const char* Mirror = "Mirror";            ///< reflectance of a perfect mirror [0,1)
/// Of panes of glass (0,1], at normal incidence; 0: opaque. Their other arrays do not matter.
constexpr const char* Transmittance = "Transmittance";
constexpr const char* RefractiveIndex = "RefractiveIndex";  ///< of such panes, 1 to 4
constexpr const char* Exitance = "Exitance";          ///< emitted on the side of the normal, lm/m², 1 or n components
constexpr const char* SurfaceId = "SurfaceId";        ///< index into the field data array SurfaceNames
constexpr const char* SurfaceNames = "SurfaceNames";  ///< field data, strings
/// Field data, strings, 3 components: subject, choice, reason of what a scene reader approximated or chose.
constexpr const char* SceneNotes = "SceneNotes";

// Luminaires, point data of vtkPolyData vertices.
constexpr const char* LuminousFlux = "LuminousFlux";  ///< lm
constexpr const char* Direction = "Direction";        ///< unit vector of the photometric axis (nadir of the table)
constexpr const char* Up = "Up";                      ///< unit vector to the half-plane C = 90 deg of the table
constexpr const char* Distribution =
    "Distribution";                     ///< 0 isotropic, 1 Lambertian, 2.. a candela table of the field data
constexpr const char* SideU = "SideU";  ///< full side of a luminous rectangle, m, 3 components; zero for a point
constexpr const char* SideV = "SideV";  ///< the other side, m
constexpr const char* LuminaireNames = "LuminaireNames";  ///< point data, strings
/// Point data, strings: the luminaire's candela table as vtkKalosCandelaText.h writes it, empty without one. It has
/// priority over the tables of the field data, which filters that append luminaires mix up.
constexpr const char* CandelaTables = "CandelaTables";
/// Field data, one array per candela table, its index appended: tuples (plane deg, angle from the pole deg, cd) sorted
/// by plane, then angle. Distribution 2 + k is the table "CandelaTable" + k.
constexpr const char* CandelaTable = "CandelaTable";
/// Field data, one value per candela table: 0 the planes share the photometric axis, 1 the axis of C = 90 deg (type B).
constexpr const char* CandelaPoles = "CandelaPoles";
/// Field data, strings, 3 components: code, file, message of every warning about a photometric file.
constexpr const char* PhotometryWarnings = "PhotometryWarnings";

// Sky, field data of luminaires; vtkKalosSkySource::Components says what it holds.
constexpr const char* Sky = "Sky";        ///< one tuple: model, illuminances, sun, ground, north
constexpr const char* SkyMap = "SkyMap";  ///< cd/m², a tuple per row from the zenith down, a component per column

// Photometric solids and polar curves, point data.
constexpr const char* Intensity = "Intensity";  ///< cd

// Results on receivers.
constexpr const char* Illuminance = "Illuminance";                            ///< lx
constexpr const char* IlluminanceStandardError = "IlluminanceStandardError";  ///< lx
constexpr const char* DirectIlluminance = "DirectIlluminance";                ///< lx, straight from the emitters
constexpr const char* DaylightFactor = "DaylightFactor";  ///< %, illuminance over the sky's on the horizontal
constexpr const char* DaylightFactorStandardError = "DaylightFactorStandardError";  ///< %
constexpr const char* KernelCorrection = "KernelCorrection";    ///< lx, altered less plain kernel, same trajectories
constexpr const char* LargestScoreShare = "LargestScoreShare";  ///< largest single score over the sum, [0, 1]
constexpr const char* IntervalTrusted = "IntervalTrusted";      ///< 1 where the standard error can be believed, else 0
constexpr const char* Valid =
    "Valid";  ///< 0 inside a solid, below a surface or outside: statistics leave it out, else 1
/// With a goal for the error: 0 missed, 1 the 95 % half-width is within it, 2 it is below the floor of a dim value.
constexpr const char* GoalStatus = "GoalStatus";
constexpr const char* IndirectIlluminanceStandardError = "IndirectIlluminanceStandardError";  ///< lx, of total - direct
constexpr const char* IlluminanceReplicates = "IlluminanceReplicates";  ///< lx, a component a replicate, if asked for
constexpr const char* IlluminanceBands = "IlluminanceBands";            ///< lx, n components, when n > 1

// Observers, point data of vtkPolyData whose normals are the lines of sight; see vtkKalosGlareRating.
constexpr const char* ObserverUp = "ObserverUp";                    ///< direction that is up for the observer
constexpr const char* UGR = "UGR";                                  ///< unified glare rating, CIE 117
constexpr const char* UGRStandardError = "UGRStandardError";        ///< of it
constexpr const char* BackgroundLuminance = "BackgroundLuminance";  ///< cd/m², indirect illuminance at the eye over pi
constexpr const char* BackgroundLuminanceStandardError = "BackgroundLuminanceStandardError";  ///< cd/m²
constexpr const char* GlareSources = "GlareSources";  ///< counts: sources, small ones, ones beyond 0.1 sr

constexpr const char* GatherRays = "GatherRays";  ///< rays that COMPENSATED has sent from a receiver

// Receivers of vtkKalosSingularEdges.
constexpr const char* EdgeDistance = "EdgeDistance";  ///< m from the nearest singular edge; infinite without any
constexpr const char* EdgeAngle = "EdgeAngle";        ///< degrees, of that edge

// Results on surfaces and images.
constexpr const char* Luminance = "Luminance";                            ///< cd/m²
constexpr const char* LuminanceStandardError = "LuminanceStandardError";  ///< cd/m²
constexpr const char* LuminanceBands = "LuminanceBands";                  ///< cd/m², n components, when n > 1

/// Field data of results under a sky: its illuminance on the horizontal without the sun, lx.
constexpr const char* SkyHorizontalIlluminance = "SkyHorizontalIlluminance";

// Field data of every result.
constexpr const char* Audit = "Audit";                      ///< strings, 3 components: subject, choice, reason
constexpr const char* Trajectories = "Trajectories";        ///< trajectories traced over all replicates
constexpr const char* Rays = "Rays";                        ///< rays traced by the solve
constexpr const char* SolveSeconds = "SolveSeconds";        ///< s, wall clock of the solve, set-up apart
constexpr const char* SolveCpuSeconds = "SolveCpuSeconds";  ///< s, processor time of the solve
constexpr const char* KalosVersion = "KalosVersion";        ///< string, what made the result
constexpr const char* Replay = "Replay";                    ///< vtkKalosIlluminance::ReplayReceiver, 5 components
constexpr const char* Seed = "Seed";                        ///< seed of the random numbers
}  // namespace vtkKalosArrayNames

#endif
