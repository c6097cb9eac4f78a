// SPDX-License-Identifier: BSD-3-Clause
#include "GltfAccessor.h"

#include <cmath>
#include <limits>

#include "../base/ByteOrder.h"
#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
constexpr std::size_t MaximumElements = 100000000;
constexpr std::size_t MaximumZeros = 4000000;  ///< elements that no bytes of the file stand behind

template <typename T>
double load(const unsigned char* from)
{
  return static_cast<double>(fromBytes<T>(from));
}

/** How the components of an accessor are stored. */
struct Storage
{
  std::size_t size;
  double (*load)(const unsigned char*);
  double largest;  ///< what a normalised integer is divided by; 1 for numbers
  bool isUnsigned;
};

Storage readStorage(const JsonCursor& type)
{
  switch (wholeNumber(type))
  {
    case 5120:
      return {1, load<std::int8_t>, 127.0, false};
    case 5121:
      return {1, load<std::uint8_t>, 255.0, true};
    case 5122:
      return {2, load<std::int16_t>, 32767.0, false};
    case 5123:
      return {2, load<std::uint16_t>, 65535.0, true};
    case 5125:
      return {4, load<std::uint32_t>, 4294967295.0, true};
    case 5126:
      return {4, load<float>, 1.0, false};
    default:
      type.failExpected("5120, 5121, 5122, 5123, 5125 or 5126");
  }
}

std::size_t componentsOf(const JsonCursor& accessor, const std::string& expected)
{
  const JsonCursor type = accessor.at("type");
  if (type.string() != expected)
  {
    type.failExpected("\"" + expected + "\"");
  }
  return expected == "SCALAR" ? 1 : static_cast<std::size_t>(expected.back() - '0');
}

/** Read `count` elements of `components` each from a view, from `holder`'s byteOffset on. */
std::vector<double> readView(const GltfFile& file, const JsonCursor& holder, const Storage& storage,
                             std::size_t components, std::size_t count)
{
  const JsonCursor& view = file.element(holder.at("bufferView"), "bufferViews");
  const Bytes bytes = file.view(view);
  const auto offset = holder.find("byteOffset");
  const std::size_t begin = offset ? wholeNumber(*offset) : 0;
  const std::size_t element = storage.size * components;
  const auto given = view.find("byteStride");
  const std::size_t stride = given ? wholeNumber(*given) : element;
  if (stride < element || stride > 252)
  {
    view.fail("a stride of " + std::to_string(stride) + " bytes; expected " + std::to_string(element) + " to 252");
  }
  if (begin > bytes.size || element > bytes.size - begin || (count - 1) > (bytes.size - begin - element) / stride)
  {
    holder.fail(std::to_string(count) + " elements do not fit into the " + std::to_string(bytes.size) +
                " bytes of the view; expected fewer");
  }
  std::vector<double> values;
  values.reserve(count * components);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      values.push_back(storage.load(bytes.data + begin + i * stride + c * storage.size));
    }
  }
  return values;
}

std::size_t readCount(const JsonCursor& count)
{
  const std::size_t elements = wholeNumber(count);
  if (elements < 1 || elements > MaximumElements)
  {
    count.failExpected("a whole number from 1 to " + std::to_string(MaximumElements));
  }
  return elements;
}

/** Replace the elements that a sparse accessor lists. */
void substitute(const GltfFile& file, const JsonCursor& sparse, const Storage& storage, std::size_t components,
                std::vector<double>& values)
{
  const std::size_t count = readCount(sparse.at("count"));
  const JsonCursor indices = sparse.at("indices");
  const std::vector<double> places = readView(file, indices, readStorage(indices.at("componentType")), 1, count);
  const std::vector<double> replacements = readView(file, sparse.at("values"), storage, components, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double place = places[i];
    if (!(place >= 0.0 && place < static_cast<double>(values.size() / components)))
    {
      indices.fail("an index beyond the accessor; expected one of its elements");
    }
    for (std::size_t c = 0; c < components; ++c)
    {
      values[static_cast<std::size_t>(place) * components + c] = replacements[i * components + c];
    }
  }
}
}  // namespace

std::vector<double> readVectors(const GltfFile& file, const JsonCursor& number, const std::string& type)
{
  const JsonCursor& accessor = file.element(number, "accessors");
  const std::size_t components = componentsOf(accessor, type);
  const std::size_t count = readCount(accessor.at("count"));
  const Storage storage = readStorage(accessor.at("componentType"));
  const bool stored = accessor.has("bufferView");
  if (!stored && count > MaximumZeros)
  {
    accessor.fail(std::to_string(count) + " elements without a \"bufferView\"; expected at most " +
                  std::to_string(MaximumZeros));
  }
  std::vector<double> values =
      stored ? readView(file, accessor, storage, components, count) : std::vector<double>(count * components);
  if (const auto sparse = accessor.find("sparse"))
  {
    substitute(file, *sparse, storage, components, values);
  }
  const auto normalized = accessor.find("normalized");
  const bool fractions = normalized && normalized->boolean();
  for (double& value : values)
  {
    if (!std::isfinite(value))
    {
      accessor.fail("a number that is not finite; expected finite ones");
    }
    value = fractions ? std::max(value / storage.largest, -1.0) : value;
  }
  return values;
}

std::vector<Vector3> readPoints(const GltfFile& file, const JsonCursor& number)
{
  const std::vector<double> numbers = readVectors(file, number, "VEC3");
  std::vector<Vector3> points(numbers.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return points;
}

std::vector<std::uint32_t> readIndices(const GltfFile& file, const JsonCursor& number)
{
  const JsonCursor& accessor = file.element(number, "accessors");
  if (!readStorage(accessor.at("componentType")).isUnsigned)
  {
    accessor.at("componentType").failExpected("an unsigned integer, 5121, 5123 or 5125");
  }
  const std::vector<double> numbers = readVectors(file, number, "SCALAR");
  return {numbers.begin(), numbers.end()};
}
}  // namespace kalos::scene
