// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosEXRReader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTestFile.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/ExrHeader.h"
#include "image/ExrPrimaries.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{
/** What is wrong with the file itself, as opposed to what OpenEXR throws. */
using Problem = std::invalid_argument;

struct Size
{
  int width;
  int height;
};

void checkFile(const char* path)
{
  std::error_code ignored;
  if (!path || !*path)
  {
    throw Problem("FileName: not set; expected the path of an .exr file");
  }
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    throw Problem("file: no such file; expected an OpenEXR image");
  }
  if (!Imf::isOpenExrFile(path))
  {
    throw Problem("file: not an OpenEXR image; expected one");
  }
  const std::string problem =
      kalos::checkExrHeader(path, static_cast<double>(vtkKalosEXRReader::MaximumNumberOfPixels()));
  if (!problem.empty())
  {
    throw Problem("header: " + problem);
  }
}

Size sizeOf(const Imf::Header& header)
{
  const Imath::Box2i& window = header.dataWindow();
  const double width = static_cast<double>(window.max.x) - window.min.x + 1.0;
  const double height = static_cast<double>(window.max.y) - window.min.y + 1.0;
  if (!(width >= 1.0 && height >= 1.0 &&
        width * height <= static_cast<double>(vtkKalosEXRReader::MaximumNumberOfPixels())))
  {
    throw Problem("header: the data window is empty or too large; expected 1 to " +
                  std::to_string(vtkKalosEXRReader::MaximumNumberOfPixels()) + " pixels");
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

bool hasChannel(const Imf::Header& header, const char* name)
{
  const Imf::Channel* channel = header.channels().findChannel(name);
  return channel && channel->xSampling == 1 && channel->ySampling == 1;
}

/** The named channels as one array, bottom row first. */
vtkSmartPointer<vtkFloatArray> readArray(Imf::InputPart& file, const char* arrayName,
                                         const std::vector<const char*>& channels)
{
  const Size size = sizeOf(file.header());
  const Imath::Box2i& window = file.header().dataWindow();
  const auto components = static_cast<int>(channels.size());
  const std::size_t pixel = sizeof(float) * components;
  const std::size_t row = pixel * size.width;
  std::vector<char> buffer(row * size.height);

  // OpenEXR addresses pixel (x, y) at base + x * pixel + y * row; the window need not start at 0.
  const auto shift = static_cast<std::ptrdiff_t>(window.min.x) * static_cast<std::ptrdiff_t>(pixel) +
                     static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(row);
  Imf::FrameBuffer frame;
  for (int c = 0; c < components; ++c)
  {
    frame.insert(channels[c], Imf::Slice(Imf::FLOAT, buffer.data() + c * sizeof(float) - shift, pixel, row));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);

  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(arrayName);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(size.width) * size.height);
  for (int y = 0; y < size.height; ++y)
  {
    const char* from = buffer.data() + row * (size.height - 1 - y);
    std::copy(from, from + row, reinterpret_cast<char*>(array->GetPointer(0)) + row * y);
  }
  return array;
}

void multiply(vtkFloatArray* array, float factor)
{
  for (vtkIdType i = 0; factor != 1.0F && i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, factor * array->GetValue(i));
  }
}

bool hasRgb(const Imf::Header& header)
{
  return hasChannel(header, "R") && hasChannel(header, "G") && hasChannel(header, "B");
}

/** The first part with luminance. */
int findPart(const Imf::MultiPartInputFile& file)
{
  for (int part = 0; part < file.parts(); ++part)
  {
    const Imf::Header& header = file.header(part);
    const bool flat = !header.hasType() || header.type() == Imf::SCANLINEIMAGE || header.type() == Imf::TILEDIMAGE;
    if (flat && (hasRgb(header) || hasChannel(header, "Y")))
    {
      return part;
    }
  }
  throw Problem(file.parts() == 1
                    ? std::string("header: no luminance; expected the channel Y, or R, G and B, at full resolution")
                    : "header: none of the " + std::to_string(file.parts()) +
                          " parts has a luminance by itself; expected a part with the channel Y, or R, G and B");
}

vtkSmartPointer<vtkImageData> readImage(const char* path)
{
  using namespace vtkKalosArrayNames;
  checkFile(path);
  Imf::MultiPartInputFile parts(path);
  Imf::InputPart file(parts, findPart(parts));
  const Imf::Header& header = file.header();
  const Size size = sizeOf(header);
  const bool rgb = hasRgb(header);
  const float unit = Imf::hasWhiteLuminance(header) ? Imf::whiteLuminance(header) : 1.0F;
  if (!(std::isfinite(unit) && unit > 0.0F))
  {
    throw Problem("header: whiteLuminance is not a number above 0; expected cd/m2");
  }

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.width, size.height, 1);
  vtkPointData* data = image->GetPointData();
  const auto add = [&](const char* name, const std::vector<const char*>& channels) {
    auto array = readArray(file, name, channels);
    multiply(array, unit);
    data->AddArray(array);
    return array;
  };
  if (rgb)
  {
    const kalos::ExrPrimaries primaries = kalos::primariesOf(header);
    const auto bands = add(LuminanceBands, {"R", "G", "B"});
    data->AddArray(kalos::luminanceOf(bands, primaries));
    if (!primaries.isRec709)
    {
      kalos::toRec709(bands, primaries);
    }
  }
  else
  {
    add(Luminance, {"Y"});
  }
  if (hasChannel(header, "Y.standardError"))
  {
    add(LuminanceStandardError, {"Y.standardError"});
  }
  data->SetActiveScalars(Luminance);
  return image;
}

Size readSize(const char* path)
{
  checkFile(path);
  const Imf::MultiPartInputFile parts(path);
  return sizeOf(parts.header(findPart(parts)));
}

/** Run a step of reading; false and one message if it fails. */
template <typename Step>
std::string attempt(const char* path, Step step)
{
  const std::string file = path && *path ? std::string(path) + ": " : "image: ";
  try
  {
    step();
    return {};
  }
  catch (const Problem& problem)
  {
    return file + problem.what();
  }
  catch (const std::exception&)
  {
    // OpenEXR's texts span lines and repeat the path.
    return file + "file: damaged or truncated; expected a complete OpenEXR image";
  }
}
}  // namespace

vtkStandardNewMacro(vtkKalosEXRReader);

vtkKalosEXRReader::vtkKalosEXRReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkKalosEXRReader::~vtkKalosEXRReader()
{
  this->SetFileName(nullptr);
}

int vtkKalosEXRReader::CanReadFile(const char* path)
{
  std::error_code ignored;
  return path && std::filesystem::is_regular_file(path, ignored) && Imf::isOpenExrFile(path);
}

int vtkKalosEXRReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  Size size{};
  const std::string problem = attempt(this->FileName, [&]() { size = readSize(this->FileName); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int extent[6] = {0, size.width - 1, 0, size.height - 1, 0, 0};
  const double zero[3] = {0.0, 0.0, 0.0};
  const double one[3] = {1.0, 1.0, 1.0};
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), zero, 3);
  info->Set(vtkDataObject::SPACING(), one, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

int vtkKalosEXRReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkSmartPointer<vtkImageData> image;
  const std::string problem = attempt(this->FileName, [&]() { image = readImage(this->FileName); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkImageData::GetData(outputVector)->ShallowCopy(image);
  return 1;
}

void vtkKalosEXRReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
