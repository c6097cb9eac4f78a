// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSceneReader
 * @brief   read a scene: a Kalos scene file, or a glTF or OBJ model
 *
 * A scene file is JSON, lengths in metres, flux in lm; unknown keys are errors; paths are relative to the scene file
 * (the rule for those that lead elsewhere is in base/FilePaths.h).
 *
 * - kalos: 1, the version of the format
 * - materials: NAME: reflectance (number or one a band, [0,1)); specular and roughness; mirror; exitance (lm/m²)
 * - surfaces: name, material, and quad {origin, u, v}, box {center, size, rotation_z_deg} or file (obj, ply, stl, off,
 *   vtp, gltf, glb) with scale (to metres) and up ("y" or "z"). A gltf, glb or obj without name is a model: its parts
 * are surfaces under their own names, and its lights and cameras join the scene unless the keys lights or cameras are
 *   false.
 * - luminaires: name, flux (lm), aim, rotation_deg, and position with distribution (isotropic, lambertian) or rectangle
 *   {center, u, v}; or position, aim and a photometric file (.ies, .ldt), with lamp_set and flux if wanted
 * - maintenance_factor, of the scene or of a luminaire: the share (0, 1] of its flux that is left; stands in SceneNotes
 * - receivers: name, and plane {origin, u, v, resolution or spacing "EN 12464-1", flip}, points (a CSV file), surface
 *   with edge_length and flip, or observer {position, target, up}; task {mean (lx), U0}, of an observer {UGR}, is what
 *   is required of the set, checked here and judged by `kalos solve`
 * - cameras: name, position, target, up, fov_deg (vertical), resolution [width, height]
 *
 * A model as FileName is read as a scene file with nothing but the model in "surfaces". Without "receivers", a model
 * gets a plane 0.75 m above its floor, see scene/WorkPlane.h. A material, luminaire or camera of the scene file
 * replaces the one of that name in a model. ModelUnit and ModelUp say what the file does not.
 *
 * From a glTF come the default scene with all visible nodes and instances, metallic-roughness and specular-glossiness
 * materials with vertex colours (COLOR_0) and KHR_materials_emissive_strength (on both sides if doubleSided), lights of
 * KHR_lights_punctual (cd, lx) and perspective cameras; y up is turned to z up. From an OBJ come objects and the
 * materials of its libraries; without "scale" and "up" it is in metres with z up.
 *
 * What is approximated or left out (mean colours of textures, degenerate faces, extensions, ...) stands with its count
 * in the field data array SceneNotes of port 0; the rules are in material/MetallicRoughness.h, model/ModelLuminaire.h
 * and material/MtlFile.h. A file is refused where a value would be wrong, and read with a note where it would not.
 *
 * Output ports:
 * - 0, vtkPolyData: all surfaces; polygons with the cell arrays of vtkKalosArrayNames.h, SurfaceId and SurfaceNames.
 *   If a material has n > 1 bands, Reflectance and Exitance have n components everywhere.
 * - 1, vtkPolyData: the luminaires, one vertex each (see vtkKalosLuminaireSource).
 * - 2, vtkMultiBlockDataSet: a named block per receiver set in file order: planes (see vtkKalosCalculationPlane) and
 *   surfaces have cell normals, points have point normals; an observer is a point whose normal is the line of sight,
 *   with the point array ObserverUp (see vtkKalosGlareRating).
 *
 * An OBJ's usemtl names are looked up in "materials", then in its libraries; "material" serves polygons without a
 * material. A VTP without "material" brings its own cell arrays Reflectance, Exitance, Specular, Roughness and Mirror.
 *
 * Errors: anything missing, unknown, of the wrong type or out of range gives an error event with one line
 * `FILE: WHERE: what is wrong and what is expected`, and empty outputs. A warning is never given instead; what the
 * reader of photometric files repairs or doubts stands in the field data array PhotometryWarnings of port 1.
 */
#ifndef vtkKalosSceneReader_h
#define vtkKalosSceneReader_h

#include <memory>  // for Internals
#include <string>  // for GetCameraName

#include "vtkAlgorithm.h"
#include "vtkKalosIOPhotometryModule.h"

class vtkMultiBlockDataSet;
class vtkPolyData;

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosSceneReader : public vtkAlgorithm
{
public:
  static vtkKalosSceneReader* New();
  vtkTypeMacro(vtkKalosSceneReader, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the scene or model file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Of a model as FileName: metres of its unit of length (1), and its axis that is up, "y" or "z" (its format's). */
  vtkSetMacro(ModelUnit, double);
  vtkGetMacro(ModelUnit, double);
  vtkSetMacro(ModelUp, std::string);
  vtkGetMacro(ModelUp, std::string);
  ///@}

  /** Whether the file is a model by its name, or looks like a Kalos scene: JSON with the key "kalos" near its start. */
  int CanReadFile(const char* path);

  ///@{
  /** The outputs: ports 0, 1 and 2. */
  vtkPolyData* GetSurfaces();
  vtkPolyData* GetLuminaires();
  vtkMultiBlockDataSet* GetReceivers();
  ///@}

  ///@{
  /**
   * Cameras of the scene, known after Update(). Position and target in m, field of view vertical in degrees, resolution
   * as width and height in pixels. An index out of range leaves the array as it is, or gives an empty name or 0.
   */
  int GetNumberOfCameras() const;
  std::string GetCameraName(int index) const;
  void GetCameraPosition(int index, double position[3]) const;
  void GetCameraTarget(int index, double target[3]) const;
  void GetCameraUp(int index, double up[3]) const;
  double GetCameraFieldOfView(int index) const;
  void GetCameraResolution(int index, int resolution[2]) const;
  ///@}

protected:
  vtkKalosSceneReader();
  ~vtkKalosSceneReader() override;

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformationVector* outputVector);

  char* FileName = nullptr;
  double ModelUnit = 1.0;
  std::string ModelUp;

private:
  vtkKalosSceneReader(const vtkKalosSceneReader&) = delete;
  void operator=(const vtkKalosSceneReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
