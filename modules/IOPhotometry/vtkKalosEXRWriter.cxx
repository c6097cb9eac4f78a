// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosEXRWriter.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "image/ImageFile.h"
#include "image/LuminancePlanes.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

namespace
{
using kalos::Plane;

void addProvenance(vtkFieldData* fields, Imf::Header& header)
{
  auto* version = vtkStringArray::SafeDownCast(fields->GetAbstractArray(vtkKalosArrayNames::KalosVersion));
  vtkDataArray* seed = fields->GetArray(vtkKalosArrayNames::Seed);
  if (version && version->GetNumberOfValues() > 0)
    header.insert("software", Imf::StringAttribute("kalos " + version->GetValue(0)));
  if (seed && seed->GetNumberOfTuples() > 0)
    header.insert("kalosSeed", Imf::StringAttribute(seed->GetVariantValue(0).ToString()));
}

void writeFile(const std::string& path, vtkImageData* image, const std::vector<Plane>& planes)
{
  const int width = image->GetDimensions()[0], height = image->GetDimensions()[1];
  Imf::Header header(width, height);
  addProvenance(image->GetFieldData(), header);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // the defaults are those of Rec. 709
  Imf::addWhiteLuminance(header, 1.0F);
  Imf::FrameBuffer frame;
  for (const Plane& plane : planes)
  {
    header.channels().insert(plane.channel, Imf::Channel(Imf::FLOAT));
    char* base = reinterpret_cast<char*>(const_cast<float*>(plane.samples.data()));
    frame.insert(plane.channel, Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * width));
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
  vtkImageData* image = vtkImageData::SafeDownCast(this->GetInput());
  const auto write = [&](const std::string& path, const std::vector<kalos::Plane>& planes) {
    writeFile(path, image, planes);
  };
  const kalos::ImageFileError error = kalos::writeImageFile(this->FileName, ".exr", image, write);
  if (!error.message.empty())
  {
    this->SetErrorCode(error.code);
    vtkErrorMacro(<< error.message);
  }
}

void vtkKalosEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
