// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKalosGlareRating
 * @brief Discomfort glare of observers: the unified glare rating (UGR) of CIE 117, with a standard error.
 *
 *   UGR = 8 log10( (0.25 / L_b) sum L^2 omega / p^2 ),   L_b = E_indirect / pi at the eye
 *
 * over luminaires and emitting surfaces in the field of view; L and omega of a luminaire come from its intensity
 * towards the eye and its projected luminous area (flat: SideU x SideV), p is Guth's position index. A luminaire
 * without an area, or below 0.005 m², counts as CIE 147 says: L^2 omega = 200 I^2 / d^2. What hides a source is found
 * by shadow rays.
 *
 * Inputs
 * - port 0, observers: vtkPolyData with a point for each eye, point normals (the lines of sight), optionally the point
 *   array ObserverUp, (0, 0, 1) where it is missing, and the arrays Illuminance, DirectIlluminance and
 *   IndirectIlluminanceStandardError that vtkKalosIlluminance gave them.
 * - port 1, surfaces, and port 2, luminaires (optional): as for vtkKalosIlluminance.
 *
 * Output: the observers with the point arrays UGR, UGRStandardError (8 / ln 10 times the relative standard error of
 * L_b; the sum over sources is exact but for how much of a source is hidden), BackgroundLuminance (cd/m²),
 * BackgroundLuminanceStandardError, and GlareSources (3 components: sources, of these small ones by CIE 147, of these
 * beyond 0.1 sr, the range of CIE 117). UGR is minus infinity without a source, NaN without a background.
 *
 * Errors: missing arrays, or a line of sight along ObserverUp, give an error event and an empty output.
 */
#ifndef vtkKalosGlareRating_h
#define vtkKalosGlareRating_h

#include "vtkKalosFiltersEstimationModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKKALOSFILTERSESTIMATION_EXPORT vtkKalosGlareRating : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosGlareRating* New();
  vtkTypeMacro(vtkKalosGlareRating, vtkPolyDataAlgorithm);

protected:
  vtkKalosGlareRating();
  ~vtkKalosGlareRating() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkKalosGlareRating(const vtkKalosGlareRating&) = delete;
  void operator=(const vtkKalosGlareRating&) = delete;
};

#endif
