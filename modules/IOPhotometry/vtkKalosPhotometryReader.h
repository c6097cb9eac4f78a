// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosPhotometryReader
 * @brief   read a manufacturer's photometric file: IES LM-63 (1986 to 2019) or EULUMDAT
 *
 * Output ports:
 * - 0, vtkPolyData: the photometric solid. The point in a direction lies at the intensity there over the largest one
 *   from the origin; x lies in the half-plane C = 0, y in C = 90 deg, the photometric axis is -z. Point array
 *   Intensity, cd.
 * - 1, vtkTable: the candela table, completed by its symmetries: a column Angle (deg from the pole) and one of cd per
 *   plane, named after it: "C 0", ... ("V 0", ... in type B).
 * - 2, vtkPolyData: the polar curves, one closed line for C 0 - 180 and one for C 90 - 270, in the x-y plane: distance
 *   from the origin is the intensity over the largest one, -y is the photometric axis, the second half-plane is on the
 *   left. Point array Intensity, cd.
 * - 3, vtkPolyData: the luminaire at its place, as vtkKalosLuminaireSource makes it, for the estimating filters.
 *
 * - FileName: a file with a line TILT= is LM-63, any other is read as EULUMDAT
 * - LampSet (default 1): which lamp set of an EULUMDAT file, from 1
 * - Position (m, default (0, 0, 0)): of the photometric centre, which is the centre of the luminous opening
 * - Aim (default (0, 0, -1)): of the photometric axis
 * - RotationDegrees (deg, default 0): about Aim, see vtkKalosLuminaireSource
 * - Flux (lm, default 0): of the luminaire instead of what the file makes; 0 keeps the file's
 * - Name (default "luminaire"): in tables and pictures
 *
 * Intensity is bilinear in the two measured angles. All factors are applied: candela multiplier, ballast factors (the
 * field that LM-63-2019 turned into a remark apart), lamp flux per 1000 lm and conversion factor, tilt factor for the
 * angle between Aim and straight down. Types A and B are looked up in their own angles, not resampled: in type A, V =
 * -90 deg is the photometric axis and C = H; in type B, H = V = 0 is, H counts towards C = 90 and V towards C = 0.
 * Symmetric files are completed: horizontal ranges 0; 0-90; 0-180; 90-270, -90-90 and 180-360; 0-360.
 * A round opening counts as a square of its area, and the height of an opening is not modelled.
 *
 * Warnings: each is a WarningEvent `FILE: line N: FIELD: ... [CODE]`, and can be asked for. Codes: ies-version,
 * ies-reversed, ies-range, ies-seam, ies-lamp-lumens, ies-future-use, ies-flux, ies-trailing; ldt-decimal-comma,
 * ldt-negative-lamps, ldt-light-output-ratio, ldt-flux, ldt-trailing.
 *
 * Errors: a file that cannot be understood gives an error event `FILE: line N: FIELD: what is wrong; expected ...` and
 * empty outputs. Files of more than 16 MiB are refused.
 */
#ifndef vtkKalosPhotometryReader_h
#define vtkKalosPhotometryReader_h

#include <memory>  // for Internals
#include <string>  // for Name

#include "vtkKalosIOPhotometryModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKKALOSIOPHOTOMETRY_EXPORT vtkKalosPhotometryReader : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosPhotometryReader* New();
  vtkTypeMacro(vtkKalosPhotometryReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the photometric file. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Lamp set of an EULUMDAT file, from 1. */
  vtkSetMacro(LampSet, int);
  vtkGetMacro(LampSet, int);
  ///@}

  ///@{
  /** Position of the photometric centre, m. */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /** Direction of the photometric axis; any length but zero. */
  vtkSetVector3Macro(Aim, double);
  vtkGetVector3Macro(Aim, double);
  ///@}

  ///@{
  /** Rotation about Aim, degrees. */
  vtkSetMacro(RotationDegrees, double);
  vtkGetMacro(RotationDegrees, double);
  ///@}

  ///@{
  /** Luminous flux of the luminaire, lm; 0: what the file makes. */
  vtkSetMacro(Flux, double);
  vtkGetMacro(Flux, double);
  ///@}

  ///@{
  /** The luminaire's name. */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  ///@}

  /** Whether the file can be read: it is parsed in full. */
  int CanReadFile(const char* path);

  ///@{
  /** What the file says, known after Update(); empty or 0 before and after errors. */
  std::string GetFormat() const;
  std::string GetLuminaireName() const;
  double GetLampFlux() const;          ///< lm of all lamps, 0 for absolute photometry
  double GetTableFlux() const;         ///< lm, integral of the intensity over all directions, in closed form
  double GetLargestIntensity() const;  ///< cd
  double GetOpeningAlongC0() const;    ///< m
  double GetOpeningAlongC90() const;   ///< m
  double GetOpeningHeight() const;     ///< m
  bool GetOpeningIsRound() const;
  int GetNumberOfLampSets() const;
  ///@}

  /** Intensity in cd in the half-plane C at the angle gamma from the photometric axis, degrees. */
  double GetIntensity(double c, double gamma) const;

  /** A direction drawn in proportion to the intensity, from two numbers in [0,1): C and gamma in degrees. */
  void SampleDirection(double u1, double u2, double angles[2]) const;

  ///@{
  /** Warnings of the last reading: the code, and the message without the file's name. */
  int GetNumberOfWarnings() const;
  std::string GetWarningCode(int index) const;
  std::string GetWarning(int index) const;
  ///@}

protected:
  vtkKalosPhotometryReader();
  ~vtkKalosPhotometryReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;
  int LampSet = 1;
  double Position[3] = {0.0, 0.0, 0.0};
  double Aim[3] = {0.0, 0.0, -1.0};
  double RotationDegrees = 0.0;
  double Flux = 0.0;
  std::string Name = "luminaire";

private:
  vtkKalosPhotometryReader(const vtkKalosPhotometryReader&) = delete;
  void operator=(const vtkKalosPhotometryReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
