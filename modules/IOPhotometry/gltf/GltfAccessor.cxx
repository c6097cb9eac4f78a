// SPDX-License-Identifier: BSD-3-Clause
#include "GltfAccessor.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
constexpr std::size_t MaximumElements = 100000000;
constexpr std::size_t MaximumZeros = 4000000;  ///< elements that no bytes of the file stand behind

template <typename T>
double Load(const unsigned char* from)
{
  T value;
  std::memcpy(&value, from, sizeof value);
  return static_cast<double>(value);
}

/** How the components of an accessor are stored. */
struct Storage
{
  std::size_t Size;
  double (*Load)(const unsigned char*);
  double Largest;  ///< what a normalised integer is divided by; 1 for numbers
  bool Unsigned;
};

Storage ReadStorage(const JsonCursor& type)
{
  switch (WholeNumber(type))
  {
    case 5120:
      return {1, Load<std::int8_t>, 127.0, false};
    case 5121:
      return {1, Load<std::uint8_t>, 255.0, true};
    case 5122:
      return {2, Load<std::int16_t>, 32767.0, false};
    case 5123:
      return {2, Load<std::uint16_t>, 65535.0, true};
    case 5125:
      return {4, Load<std::uint32_t>, 4294967295.0, true};
    case 5126:
      return {4, Load<float>, 1.0, false};
    default:
      type.FailExpected("5120, 5121, 5122, 5123, 5125 or 5126");
  }
}

std::size_t ComponentsOf(const JsonCursor& accessor, const std::string& expected)
{
  const JsonCursor type = accessor.At("type");
  if (type.String() != expected)
  {
    type.FailExpected("\"" + expected + "\"");
  }
  return expected == "SCALAR" ? 1 : static_cast<std::size_t>(expected.back() - '0');
}

/** Read `count` elements of `components` each from a view, from `holder`'s byteOffset on. */
std::vector<double> ReadView(const GltfFile& file, const JsonCursor& holder, const Storage& storage,
                             std::size_t components, std::size_t count)
{
  const JsonCursor& view = file.Element(holder.At("bufferView"), "bufferViews");
  const Bytes bytes = file.View(view);
  const auto offset = holder.Find("byteOffset");
  const std::size_t begin = offset ? WholeNumber(*offset) : 0;
  const std::size_t element = storage.Size * components;
  const auto given = view.Find("byteStride");
  const std::size_t stride = given ? WholeNumber(*given) : element;
  if (stride < element || stride > 252)
  {
    view.Fail("a stride of " + std::to_string(stride) + " bytes; expected " + std::to_string(element) + " to 252");
  }
  if (begin > bytes.Size || element > bytes.Size - begin || (count - 1) > (bytes.Size - begin - element) / stride)
  {
    holder.Fail(std::to_string(count) + " elements do not fit into the " + std::to_string(bytes.Size) +
                " bytes of the view; expected fewer");
  }
  std::vector<double> values;
  values.reserve(count * components);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      values.push_back(storage.Load(bytes.Data + begin + i * stride + c * storage.Size));
    }
  }
  return values;
}

std::size_t ReadCount(const JsonCursor& count)
{
  const std::size_t elements = WholeNumber(count);
  if (elements < 1 || elements > MaximumElements)
  {
    count.FailExpected("a whole number from 1 to " + std::to_string(MaximumElements));
  }
  return elements;
}

/** Replace the elements that a sparse accessor lists. */
void Substitute(const GltfFile& file, const JsonCursor& sparse, const Storage& storage, std::size_t components,
                std::vector<double>& values)
{
  const std::size_t count = ReadCount(sparse.At("count"));
  const JsonCursor indices = sparse.At("indices");
  const std::vector<double> places = ReadView(file, indices, ReadStorage(indices.At("componentType")), 1, count);
  const std::vector<double> replacements = ReadView(file, sparse.At("values"), storage, components, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double place = places[i];
    if (!(place >= 0.0 && place < static_cast<double>(values.size() / components)))
    {
      indices.Fail("an index beyond the accessor; expected one of its elements");
    }
    for (std::size_t c = 0; c < components; ++c)
    {
      values[static_cast<std::size_t>(place) * components + c] = replacements[i * components + c];
    }
  }
}
}  // namespace

std::vector<double> ReadVectors(const GltfFile& file, const JsonCursor& number, const std::string& type)
{
  const JsonCursor& accessor = file.Element(number, "accessors");
  const std::size_t components = ComponentsOf(accessor, type);
  const std::size_t count = ReadCount(accessor.At("count"));
  const Storage storage = ReadStorage(accessor.At("componentType"));
  const bool stored = accessor.Has("bufferView");
  if (!stored && count > MaximumZeros)
  {
    accessor.Fail(std::to_string(count) + " elements without a \"bufferView\"; expected at most " +
                  std::to_string(MaximumZeros));
  }
  std::vector<double> values =
      stored ? ReadView(file, accessor, storage, components, count) : std::vector<double>(count * components);
  if (const auto sparse = accessor.Find("sparse"))
  {
    Substitute(file, *sparse, storage, components, values);
  }
  const auto normalized = accessor.Find("normalized");
  const bool fractions = normalized && normalized->Boolean();
  for (double& value : values)
  {
    if (!std::isfinite(value))
    {
      accessor.Fail("a number that is not finite; expected finite ones");
    }
    value = fractions ? std::max(value / storage.Largest, -1.0) : value;
  }
  return values;
}

std::vector<Vector3> ReadPoints(const GltfFile& file, const JsonCursor& number)
{
  const std::vector<double> numbers = ReadVectors(file, number, "VEC3");
  std::vector<Vector3> points(numbers.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return points;
}

std::vector<std::uint32_t> ReadIndices(const GltfFile& file, const JsonCursor& number)
{
  const JsonCursor& accessor = file.Element(number, "accessors");
  if (!ReadStorage(accessor.At("componentType")).Unsigned)
  {
    accessor.At("componentType").FailExpected("an unsigned integer, 5121, 5123 or 5125");
  }
  const std::vector<double> numbers = ReadVectors(file, number, "SCALAR");
  return {numbers.begin(), numbers.end()};
}
}  // namespace kalos::scene
