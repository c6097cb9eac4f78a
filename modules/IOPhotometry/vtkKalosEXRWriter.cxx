// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosEXRWriter.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "TemporaryFile.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

namespace
{
/** One channel: its samples from the top row down. */
struct Plane
{
  std::string Channel;
  std::vector<float> Samples;
};

/** Component of an array as float32; throws at the first value that is no luminance. */
Plane MakePlane(const char* channel, vtkDataArray* array, int component, int width, int height)
{
  Plane plane{channel, std::vector<float>(static_cast<std::size_t>(width) * height)};
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(y) * width + x, component);
      // Also false for NaN.
      if (!(value >= 0.0 && value <= static_cast<double>(std::numeric_limits<float>::max())))
      {
        std::ostringstream message;
        message << "pixel (" << x << ", " << y << "): " << array->GetName() << " is " << value
                << "; expected a finite float32 value of at least 0 cd/m2";
        throw std::invalid_argument(message.str());
      }
      plane.Samples[static_cast<std::size_t>(height - 1 - y) * width + x] = static_cast<float>(value);
    }
  }
  return plane;
}

std::vector<Plane> MakePlanes(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("image: not one slice of pixels; expected a width x height x 1 image");
  }
  vtkPointData* data = image->GetPointData();
  vtkDataArray* bands = data->GetArray(vtkKalosArrayNames::LuminanceBands);
  vtkDataArray* luminance = data->GetArray(vtkKalosArrayNames::Luminance);
  vtkDataArray* error = data->GetArray(vtkKalosArrayNames::LuminanceStandardError);
  std::vector<Plane> planes;
  if (bands && bands->GetNumberOfComponents() == 3)
  {
    const char* const names[3] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c)
    {
      planes.push_back(MakePlane(names[c], bands, c, size[0], size[1]));
    }
  }
  else if (luminance && luminance->GetNumberOfComponents() == 1)
  {
    planes.push_back(MakePlane("Y", luminance, 0, size[0], size[1]));
  }
  else
  {
    throw std::invalid_argument("image: no luminance; expected the point array Luminance, 1 component, in cd/m2");
  }
  if (error)
  {
    planes.push_back(MakePlane("Y.standardError", error, 0, size[0], size[1]));
  }
  return planes;
}

void WriteFile(const std::string& path, int width, int height, const std::vector<Plane>& planes)
{
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // the defaults are those of Rec. 709
  Imf::addWhiteLuminance(header, 1.0F);
  Imf::FrameBuffer frame;
  for (const Plane& plane : planes)
  {
    header.channels().insert(plane.Channel, Imf::Channel(Imf::FLOAT));
    char* base = reinterpret_cast<char*>(const_cast<float*>(plane.Samples.data()));
    frame.insert(plane.Channel, Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * width));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
}
}  // namespace

vtkStandardNewMacro(vtkKalosEXRWriter);

vtkKalosEXRWriter::vtkKalosEXRWriter() = default;

vtkKalosEXRWriter::~vtkKalosEXRWriter()
{
  this->SetFileName(nullptr);
}

int vtkKalosEXRWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkKalosEXRWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("image: FileName: not set; expected the path of an .exr file");
    return;
  }
  try
  {
    vtkImageData* image = vtkImageData::SafeDownCast(this->GetInput());
    const std::vector<Plane> planes = MakePlanes(image);
    const kalos::TemporaryFile temporary(this->FileName);
    WriteFile(temporary.Path(), image->GetDimensions()[0], image->GetDimensions()[1], planes);
    temporary.MoveIntoPlace();
  }
  catch (const std::invalid_argument& error)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< this->FileName << ": " << error.what());
  }
  catch (const std::exception&)
  {
    // OpenEXR's text names the temporary file, which helps nobody.
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< this->FileName << ": file: cannot be written; expected a writable folder with room on the disk");
  }
}

void vtkKalosEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
