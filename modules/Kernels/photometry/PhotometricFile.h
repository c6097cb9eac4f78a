// SPDX-License-Identifier: BSD-3-Clause
// What a manufacturer's photometric file says of a luminaire: IES LM-63 (1986 to 2019) and EULUMDAT.
#ifndef kalos_photometry_PhotometricFile_h
#define kalos_photometry_PhotometricFile_h

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "photometry/CandelaTable.h"

namespace kalos
{
/// A repair or a contradiction that a user should know of; codes never change their meaning (see PhotometricFile.cxx).
struct PhotometryWarning
{
  std::string code;   ///< for counting, as "ies-range"
  int line = 0;       ///< from 1
  std::string field;  ///< of the format
  std::string text;

  std::string message() const;  ///< "line N: FIELD: TEXT [CODE]"
};

/// What makes a file unusable: "line N: FIELD: what is wrong; expected ...".
class PhotometryError : public std::runtime_error
{
public:
  PhotometryError(int line, const std::string& field, const std::string& what);
};

/// The luminous opening, flat, across the photometric axis and centred on the photometric centre.
struct Opening
{
  bool round = false;
  double alongC0 = 0;   ///< m, size in the plane C = 0; the diameter of a round one
  double alongC90 = 0;  ///< m
  double height = 0;    ///< m along the axis; told, not modelled

  bool isPoint() const { return !(this->alongC0 > 0 && this->alongC90 > 0); }
};

struct PhotometricFile
{
  std::string format;     ///< as "IES LM-63-2002", "EULUMDAT"
  std::string name;       ///< of the luminaire, as far as the file tells
  CandelaTable table;     ///< cd of the luminaire, all multipliers applied
  double lampFlux = 0;    ///< lm of all lamps by the header; 0 when the photometry is absolute
  double statedFlux = 0;  ///< lm of the luminaire that the header claims; 0 when it claims none
  Opening opening{};
  int lampSets = 1;                                 ///< of an EULUMDAT file
  std::vector<double> tiltAngles{}, tiltFactors{};  ///< of TILT=INCLUDE or of a tilt file; empty for TILT=NONE
  std::vector<PhotometryWarning> warnings{};

  /// Factor on all intensities when the photometric axis is turned `degrees` away from straight down.
  double tiltFactor(double degrees) const;
};

struct PhotometryOptions
{
  int lampSet = 1;  ///< of an EULUMDAT file, from 1
  /// Text of the file that TILT= names, or nothing when there is none.
  std::function<std::optional<std::string>(const std::string&)> findTilt;
};

constexpr std::size_t maxPhotometryBytes = 1 << 24;

/// IES when a line starts with TILT=, else EULUMDAT. Throws PhotometryError.
PhotometricFile parsePhotometry(const std::string& text, const PhotometryOptions& options = {});

PhotometricFile parseIes(const std::string& text, const PhotometryOptions& options);
PhotometricFile parseEulumdat(const std::string& text, const PhotometryOptions& options);
}  // namespace kalos

#endif
