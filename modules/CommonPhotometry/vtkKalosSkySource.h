// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSkySource
 * @brief   sky, sun and ground: what light from outside comes from
 *
 * Input (optional): vtkPolyData of luminaires. Output: the same luminaires, or none, with the sky in the field data
 * arrays Sky and SkyMap of vtkKalosArrayNames.h. It goes where luminaires go: the third input of vtkKalosIlluminance.
 *
 * Properties:
 * - Model (1): 1 to 16, a type of CIE S 011 (ISO 15469), 16 being the traditional overcast sky; PEREZ, the all-weather
 *   model; MAP, a picture.
 * - HorizontalIlluminance (10000 lx): at least 0, of the sky without the sun; negative: not given.
 * - ZenithLuminance (-1 cd/m2): at least 0, instead of it; negative: not given.
 * - SunElevationDegrees (45): 0 to 90. SunAzimuthDegrees (180): clockwise from north, seen from above.
 * - SunNormalIlluminance (0 lx): at least 0, across the sun's rays; negative: that of PEREZ.
 * - DirectNormalIrradiance, DiffuseHorizontalIrradiance (0 W/m2): at least 0, for PEREZ.
 * - GroundReflectance (0): 0 to 1. NorthDegrees (0): north is +y turned clockwise by it, seen from above.
 *
 * The sun is a disc of 0.53 degrees; with SunNormalIlluminance 0 it only says where the sky is bright. Below the
 * horizon the ground has the luminance rho E_h / pi, E_h being the sky's horizontal illuminance. Where neither
 * HorizontalIlluminance nor ZenithLuminance is given, PEREZ takes its luminous efficacies and MAP its own values.
 *
 * A map is latitude-longitude: its top row is the zenith, its middle column north, east is to the right. It comes by
 * SetMap().
 *
 * Errors: a value out of range gives an error event and an empty output.
 */
#ifndef vtkKalosSkySource_h
#define vtkKalosSkySource_h

#include <string>  // for Check

#include "vtkFloatArray.h"  // for the map
#include "vtkKalosCommonPhotometryModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"  // for the map

class VTKKALOSCOMMONPHOTOMETRY_EXPORT vtkKalosSkySource : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosSkySource* New();
  vtkTypeMacro(vtkKalosSkySource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of Model beside the types 1 to 16. */
  enum Models
  {
    PEREZ = 0,
    MAP = -1
  };

  /** What the components of the array Sky mean. */
  enum Components
  {
    MODEL,
    HORIZONTAL_ILLUMINANCE,
    ZENITH_LUMINANCE,
    SUN_ELEVATION,
    SUN_AZIMUTH,
    SUN_ILLUMINANCE,
    DIRECT_IRRADIANCE,
    DIFFUSE_IRRADIANCE,
    GROUND_REFLECTANCE,
    NORTH,
    NUMBER_OF_COMPONENTS
  };

  ///@{
  /** See the table above. */
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  vtkSetMacro(HorizontalIlluminance, double);
  vtkGetMacro(HorizontalIlluminance, double);
  vtkSetMacro(ZenithLuminance, double);
  vtkGetMacro(ZenithLuminance, double);
  vtkSetMacro(SunElevationDegrees, double);
  vtkGetMacro(SunElevationDegrees, double);
  vtkSetMacro(SunAzimuthDegrees, double);
  vtkGetMacro(SunAzimuthDegrees, double);
  vtkSetMacro(SunNormalIlluminance, double);
  vtkGetMacro(SunNormalIlluminance, double);
  vtkSetMacro(DirectNormalIrradiance, double);
  vtkGetMacro(DirectNormalIrradiance, double);
  vtkSetMacro(DiffuseHorizontalIrradiance, double);
  vtkGetMacro(DiffuseHorizontalIrradiance, double);
  vtkSetMacro(GroundReflectance, double);
  vtkGetMacro(GroundReflectance, double);
  vtkSetMacro(NorthDegrees, double);
  vtkGetMacro(NorthDegrees, double);
  ///@}

  /** The map, cd/m²: a tuple per row from the top, a component per column. */
  void SetMap(vtkFloatArray* rows);

protected:
  vtkKalosSkySource();
  ~vtkKalosSkySource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Model = 1;
  double HorizontalIlluminance = 10000.0;
  double ZenithLuminance = -1.0;
  double SunElevationDegrees = 45.0;
  double SunAzimuthDegrees = 180.0;
  double SunNormalIlluminance = 0.0;
  double DirectNormalIrradiance = 0.0;
  double DiffuseHorizontalIrradiance = 0.0;
  double GroundReflectance = 0.0;
  double NorthDegrees = 0.0;
  vtkSmartPointer<vtkFloatArray> Map;

private:
  vtkKalosSkySource(const vtkKalosSkySource&) = delete;
  void operator=(const vtkKalosSkySource&) = delete;

  /** Empty if all properties are in range, else what is wrong and what is expected. */
  std::string Check() const;
};

#endif
