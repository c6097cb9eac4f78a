// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSceneReader
 * @brief   read a Kalos scene file: surfaces, luminaires, receivers and cameras
 *
 * The file is JSON, lengths in metres, flux in lm; unknown keys are errors; paths are relative to the scene file.
 *
 * | section    | members                                                                                             |
 * |------------|-----------------------------------------------------------------------------------------------------|
 * | kalos      | 1, the version of the format                                                                        |
 * | materials  | NAME: reflectance (number or one a band, [0,1)); specular and roughness; mirror; exitance (lm/m²)   |
 * | surfaces   | name, material, and quad {origin, u, v}, box {center, size, rotation_z_deg} or file (obj, ply, stl,
 * vtp) | | luminaires | name, flux (lm), aim, rotation_deg, and position with distribution (isotropic, lambertian) or
 * rectangle {center, u, v}; or position, aim and a photometric file (.ies, .ldt), with lamp_set and flux if wanted | |
 * receivers  | name, and plane {origin, u, v, resolution or spacing "EN 12464-1", flip}, points (a CSV file) or surface
 * with edge_length and flip | | cameras    | name, position, target, up, fov_deg (vertical), resolution [width, height]
 * |
 *
 * Output ports:
 * - 0, vtkPolyData: all surfaces; polygons with the cell arrays of vtkKalosArrayNames.h, SurfaceId and SurfaceNames.
 *   If a material has n > 1 bands, Reflectance and Exitance have n components everywhere.
 * - 1, vtkPolyData: the luminaires, one vertex each (see vtkKalosLuminaireSource).
 * - 2, vtkMultiBlockDataSet: a named block per receiver set in file order: planes (see vtkKalosCalculationPlane) and
 *   surfaces have cell normals, points have point normals.
 *
 * An OBJ's usemtl names are looked up in "materials"; "material" serves the faces before the first usemtl. A VTP
 * without "material" brings its own cell arrays Reflectance, Exitance, Specular, Roughness and Mirror.
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
  /** Path of the scene file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether the file looks like a Kalos scene: JSON text with the key "kalos" near its start. */
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

private:
  vtkKalosSceneReader(const vtkKalosSceneReader&) = delete;
  void operator=(const vtkKalosSceneReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
