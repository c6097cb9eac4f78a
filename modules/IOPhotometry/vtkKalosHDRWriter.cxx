// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosHDRWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "image/ImageFile.h"
#include "image/LuminancePlanes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

namespace
{
constexpr double Efficacy = 179.0;  // lm/W of Radiance's white

using Color = std::array<double, 3>;

/** The luminance that Radiance sees in a colour, per efficacy. */
double radianceLuminance(const Color& c)
{
  return 0.265 * c[0] + 0.670 * c[1] + 0.065 * c[2];
}

/** Three mantissas with a common exponent; a reader adds half a step. */
std::array<unsigned char, 4> encode(const Color& color)
{
  const double largest = std::max({color[0], color[1], color[2]});
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (!(largest > 0.0) || exponent <= -128)
  {
    return {0, 0, 0, 0};
  }
  std::array<unsigned char, 4> pixel{};
  for (int c = 0; c < 3; ++c)
  {
    pixel[c] = static_cast<unsigned char>(std::min(255.0, std::ldexp(color[c], 8 - exponent)));
  }
  pixel[3] = static_cast<unsigned char>(exponent + 128);
  return pixel;
}

/** The pixel's colour in Radiance's units, of the luminance that the bands have. */
Color colorOf(const std::vector<kalos::Plane>& planes, std::size_t i)
{
  if (planes[0].channel != "R")
  {
    const double value = planes[0].samples[i] / Efficacy;
    return {value, value, value};
  }
  const Color rgb{planes[0].samples[i], planes[1].samples[i], planes[2].samples[i]};
  const double seen = radianceLuminance(rgb);
  const double scale = seen > 0.0 ? (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / (Efficacy * seen) : 0.0;
  return {scale * rgb[0], scale * rgb[1], scale * rgb[2]};
}

void writeFile(const std::string& path, const int size[3], const std::vector<kalos::Plane>& planes,
               const std::string& view)
{
  std::ofstream file(path, std::ios::binary);
  file << "#?RADIANCE\nSOFTWARE=Kalos\n";
  if (!view.empty())
  {
    file << "VIEW=" << view << "\n";
  }
  file << "FORMAT=32-bit_rle_rgbe\n\n-Y " << size[1] << " +X " << size[0] << "\n";
  // Flat scan lines: a pixel whose largest mantissa is 128 or more cannot be taken for a run.
  for (std::size_t i = 0; i < planes[0].samples.size(); ++i)
  {
    const auto pixel = encode(colorOf(planes, i));
    file.write(reinterpret_cast<const char*>(pixel.data()), 4);
  }
  file.close();
  if (!file)
  {
    throw std::runtime_error("write");
  }
}
}  // namespace

vtkStandardNewMacro(vtkKalosHDRWriter);

vtkKalosHDRWriter::vtkKalosHDRWriter() = default;

vtkKalosHDRWriter::~vtkKalosHDRWriter()
{
  this->SetFileName(nullptr);
}

int vtkKalosHDRWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkKalosHDRWriter::WriteData()
{
  vtkImageData* image = vtkImageData::SafeDownCast(this->GetInput());
  const auto write = [&](const std::string& path, const std::vector<kalos::Plane>& planes) {
    if (this->View.find_first_of("\r\n") != std::string::npos)
    {
      throw std::invalid_argument("View: more than one line; expected view options of Radiance");
    }
    writeFile(path, image->GetDimensions(), planes, this->View);
  };
  const kalos::ImageFileError error = kalos::writeImageFile(this->FileName, ".hdr", image, write);
  if (!error.message.empty())
  {
    this->SetErrorCode(error.code);
    vtkErrorMacro(<< error.message);
  }
}

void vtkKalosHDRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "View: " << this->View << "\n";
}
