// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKalosLuminanceImage
 * @brief Luminance seen from a camera, with a standard error per pixel.
 *
 * Inputs: port 0 surfaces, port 1 luminaires (optional), as for vtkKalosIlluminance. Output: vtkImageData of Resolution
 * with the point arrays Luminance (cd/m²), LuminanceStandardError (cd/m²), IntervalTrusted (0 or 1: whether that
 * error can be believed) and, for n > 1 bands, LuminanceBands; row 0
 * is at the bottom; 0 where nothing is seen; and the field data of vtkKalosEstimatorAlgorithm.
 *
 * The double local estimate (E2) at the point y that the centre of the pixel sees: L = M0/pi + rho E(y)/pi for a
 * Lambertian y, E weighted by the BRDF for a glossy one; mirrors are followed. Without Trajectories and without a goal
 * it runs 1024 trajectories per pixel. Luminaires have no body and are seen in mirrors only.
 */
#ifndef vtkKalosLuminanceImage_h
#define vtkKalosLuminanceImage_h

#include "vtkKalosEstimatorAlgorithm.h"

class VTKKALOSFILTERSESTIMATION_EXPORT vtkKalosLuminanceImage : public vtkKalosEstimatorAlgorithm
{
public:
  static vtkKalosLuminanceImage* New();
  vtkTypeMacro(vtkKalosLuminanceImage, vtkKalosEstimatorAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Eye of the camera, m. Default (0, -1, 0).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * Point the camera looks at, m; must differ from Position. Default (0, 0, 0).
   */
  vtkSetVector3Macro(Target, double);
  vtkGetVector3Macro(Target, double);
  ///@}

  ///@{
  /**
   * Direction that is up in the image; must not be parallel to the line of sight. Default (0, 0, 1).
   */
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Vertical field of view, degrees, in (0, 180). Default 45.
   */
  vtkSetMacro(FieldOfView, double);
  vtkGetMacro(FieldOfView, double);
  ///@}

  ///@{
  /**
   * Columns and rows, each at least 1. Default 256 x 256.
   */
  vtkSetVector2Macro(Resolution, int);
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /**
   * Lines of sight in a pixel that sees an edge, 1 to 256; others have one through their centre. 1: no anti-aliasing.
   * Default 16.
   */
  vtkSetMacro(PixelSamples, int);
  vtkGetMacro(PixelSamples, int);
  ///@}

protected:
  vtkKalosLuminanceImage();
  ~vtkKalosLuminanceImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Position[3] = {0, -1, 0};
  double Target[3] = {0, 0, 0};
  double Up[3] = {0, 0, 1};
  double FieldOfView = 45;
  int Resolution[2] = {256, 256};
  int PixelSamples = 16;

private:
  vtkKalosLuminanceImage(const vtkKalosLuminanceImage&) = delete;
  void operator=(const vtkKalosLuminanceImage&) = delete;
};

#endif
