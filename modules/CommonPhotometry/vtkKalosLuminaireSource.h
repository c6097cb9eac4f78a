// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosLuminaireSource
 * @brief   one luminaire: a point, a luminous rectangle, or one with a measured distribution
 *
 * Output: vtkPolyData with one vertex and the point arrays of vtkKalosArrayNames.h: LuminousFlux, Direction, Up,
 * Distribution, SideU, SideV and LuminaireNames. Several luminaires are appended with vtkAppendPolyData. A luminaire
 * has no body: nothing hits it, nothing is shadowed by it.
 *
 * - Shape (default POINT): POINT, RECTANGLE
 * - Position (m, default (0, 0, 0)): finite; the point, or the centre of the rectangle
 * - Aim (default (0, 0, -1)): finite, not zero (any length); along +-(SideU x SideV) of a rectangle
 * - RotationDegrees (deg, default 0): finite
 * - Flux (lm, default 1000): finite, at least 0
 * - Distribution (default LAMBERTIAN): ISOTROPIC, LAMBERTIAN, MEASURED; a rectangle is always Lambertian
 * - SideU, SideV (m, default 0.6 m square): finite, not parallel, not zero; ignored for a point
 * - OpeningAlongC0, OpeningAlongC90 (m, default 0): at least 0; sides of the luminous opening of a MEASURED point; 0:
 *   none
 * - Name (default "luminaire"): any
 *
 * A Lambertian source sends I(theta) = Flux / pi cos(theta) [cd] into the half-space around Aim; an isotropic one
 * Flux / (4 pi) [cd] everywhere. A rectangle emits on one side only, that of Aim.
 *
 * A MEASURED source takes its intensities from a candela table, scaled to Flux; the output's field data then hold the
 * arrays CandelaTable0 and CandelaPoles, and as text in the point array CandelaTables, which survives appending.
 * vtkKalosPhotometryReader makes such sources from manufacturers' files. Its opening lies across Aim about Position.
 * Receivers closer than 5 times its larger side see it as an area whose every spot radiates like the whole, others as a
 * point.
 *
 * Up is the half-plane C = 90 deg of the distribution. Without rotation it is world +y made perpendicular to Aim, or +z
 * made perpendicular where Aim is within 0.6 deg of +-y; so a luminaire that looks down has C = 0 along +x.
 * RotationDegrees turns it about Aim, counter-clockwise as seen from behind the luminaire (from above, if it looks
 * down).
 *
 * Errors: a value out of range gives an error event and an empty output.
 */
#ifndef vtkKalosLuminaireSource_h
#define vtkKalosLuminaireSource_h

#include <string>  // for Name

#include "vtkDoubleArray.h"  // for the candela table
#include "vtkKalosCommonPhotometryModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"  // for the candela table

class VTKKALOSCOMMONPHOTOMETRY_EXPORT vtkKalosLuminaireSource : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosLuminaireSource* New();
  vtkTypeMacro(vtkKalosLuminaireSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    POINT = 0,
    RECTANGLE = 1
  };

  /** Values of the array Distribution. */
  enum Distributions
  {
    ISOTROPIC = 0,
    LAMBERTIAN = 1,
    MEASURED = 2
  };

  ///@{
  /** POINT or RECTANGLE. */
  vtkSetClampMacro(Shape, int, POINT, RECTANGLE);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /** The point, or the centre of the rectangle, m. */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /** Direction of the photometric axis; any length but zero. */
  vtkSetVector3Macro(Aim, double);
  vtkGetVector3Macro(Aim, double);
  ///@}

  ///@{
  /** Rotation of Up about Aim, degrees. */
  vtkSetMacro(RotationDegrees, double);
  vtkGetMacro(RotationDegrees, double);
  ///@}

  ///@{
  /** Luminous flux, lm. */
  vtkSetMacro(Flux, double);
  vtkGetMacro(Flux, double);
  ///@}

  ///@{
  /** ISOTROPIC, LAMBERTIAN or MEASURED; read for a point only. */
  vtkSetClampMacro(Distribution, int, ISOTROPIC, MEASURED);
  vtkGetMacro(Distribution, int);
  ///@}

  /**
   * Tuples (plane, angle from the pole, candela) as described for the array CandelaTable; the pole is the photometric
   * axis, or with `sidePole` the axis of C = 90 deg. Turns Distribution to MEASURED.
   */
  void SetCandelaTable(vtkDoubleArray* tuples, bool sidePole);

  ///@{
  /** Sides of the luminous opening of a MEASURED point along C = 0 and C = 90 deg, m; 0 for none. */
  vtkSetMacro(OpeningAlongC0, double);
  vtkGetMacro(OpeningAlongC0, double);
  vtkSetMacro(OpeningAlongC90, double);
  vtkGetMacro(OpeningAlongC90, double);
  ///@}

  ///@{
  /** Full sides of the rectangle, m. */
  vtkSetVector3Macro(SideU, double);
  vtkGetVector3Macro(SideU, double);
  vtkSetVector3Macro(SideV, double);
  vtkGetVector3Macro(SideV, double);
  ///@}

  ///@{
  /** The luminaire's name in tables and pictures. */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  ///@}

protected:
  vtkKalosLuminaireSource();
  ~vtkKalosLuminaireSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Shape = POINT;
  double Position[3] = {0.0, 0.0, 0.0};
  double Aim[3] = {0.0, 0.0, -1.0};
  double RotationDegrees = 0.0;
  double Flux = 1000.0;
  int Distribution = LAMBERTIAN;
  double SideU[3] = {0.6, 0.0, 0.0};
  double SideV[3] = {0.0, 0.6, 0.0};
  double OpeningAlongC0 = 0.0;
  double OpeningAlongC90 = 0.0;
  bool SidePole = false;
  vtkSmartPointer<vtkDoubleArray> CandelaTable;
  std::string Name = "luminaire";

private:
  vtkKalosLuminaireSource(const vtkKalosLuminaireSource&) = delete;
  void operator=(const vtkKalosLuminaireSource&) = delete;

  /** Empty if all is well, else what is wrong and what is expected. */
  std::string Check() const;
};

#endif
