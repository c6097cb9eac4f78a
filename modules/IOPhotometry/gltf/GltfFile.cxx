// SPDX-License-Identifier: BSD-3-Clause
#include "GltfFile.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "../base/ByteOrder.h"
#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/Names.h"
#include "UriText.h"

namespace kalos::scene
{
namespace
{
constexpr std::uintmax_t MaximumFileBytes = std::uintmax_t{1} << 31;

std::string readFile(const std::string& path, const std::string& where)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw InputError(where, "no file " + path + "; expected it there");
  }
  if (std::filesystem::file_size(path, error) > MaximumFileBytes)
  {
    throw InputError(where, "larger than 2 GiB; expected a smaller file");
  }
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file)
  {
    throw InputError(where, path + " cannot be read; expected a readable file");
  }
  return content;
}

std::uint32_t word(const std::string& content, std::size_t at)
{
  return fromBytes<std::uint32_t>(content.data() + at);
}

/** Extensions that are read, or that change no light. */
const std::set<std::string> ReadExtensions = {"KHR_lights_punctual",        "KHR_materials_emissive_strength",
                                              "KHR_mesh_quantization",      "EXT_mesh_gpu_instancing",
                                              "KHR_node_visibility",        "KHR_materials_pbrSpecularGlossiness",
                                              "KHR_texture_transform",      "KHR_draco_mesh_compression",
                                              "KHR_materials_transmission", "KHR_materials_diffuse_transmission"};

/** How often each extension stands in a value or below it. */
void countExtensions(const nlohmann::json& json, std::map<std::string, int>& counts)
{
  for (const auto& [key, value] : json.items())
  {
    if (key == "extensions" && value.is_object())
    {
      for (const auto& [name, ignored] : value.items())
      {
        ++counts[name];
      }
    }
    if (value.is_structured())
    {
      countExtensions(value, counts);
    }
  }
}

/** Extensions that a file may require; any other is an error. */
const std::set<std::string> KnownExtensions = {"KHR_node_visibility",        "KHR_materials_pbrSpecularGlossiness",
                                               "KHR_lights_punctual",        "KHR_materials_emissive_strength",
                                               "KHR_mesh_quantization",      "EXT_mesh_gpu_instancing",
                                               "KHR_materials_unlit",        "KHR_texture_transform",
                                               "KHR_materials_ior",          "KHR_materials_specular",
                                               "KHR_materials_clearcoat",    "KHR_materials_sheen",
                                               "KHR_materials_transmission", "KHR_materials_volume",
                                               "KHR_materials_iridescence",  "KHR_materials_anisotropy",
                                               "KHR_materials_variants"};
}  // namespace

GltfFile::GltfFile(const std::string& path, Notes& notes) : Path(path), FileNotes(notes)
{
  std::string content = readFile(path, "file");
  if (content.compare(0, 4, "glTF") != 0)
  {
    this->Json = parseJson(content);
  }
  else
  {
    this->Content = std::move(content);
    const std::size_t size = this->Content.size();
    if (size < 20 || word(this->Content, 4) != 2)
    {
      throw InputError("header", "no glTF binary of version 2; expected one");
    }
    if (word(this->Content, 8) > size)
    {
      throw InputError("header", "a file of " + std::to_string(size) + " bytes that says it has " +
                                     std::to_string(word(this->Content, 8)) + "; expected a complete file");
    }
    const std::size_t text = word(this->Content, 12);
    if (word(this->Content, 16) != 0x4E4F534AU || text > size - 20)
    {
      throw InputError("header", "the first chunk is no JSON, or not complete; expected JSON");
    }
    this->Json = parseJson(this->Content.substr(20, text));
    const std::size_t next = 20 + text;
    if (size - next >= 8 && word(this->Content, next + 4) == 0x004E4942U)
    {
      this->Chunk = {reinterpret_cast<const unsigned char*>(this->Content.data()) + next + 8,
                     word(this->Content, next)};
      if (this->Chunk.size > size - next - 8)
      {
        throw InputError("header", "the binary chunk is not complete; expected " + std::to_string(this->Chunk.size) +
                                       " bytes, found " + std::to_string(size - next - 8));
      }
      this->HasChunk = true;
    }
  }
  const JsonCursor version = this->root().at("asset").at("version");
  if (version.string().compare(0, 2, "2.") != 0)
  {
    version.failExpected("\"2.0\"");
  }
  const auto required = this->root().find("extensionsRequired");
  for (const JsonCursor& extension : required ? required->items() : std::vector<JsonCursor>())
  {
    if (KnownExtensions.count(extension.string()) == 0)
    {
      extension.failExpected("a file without compression and extensions that Kalos does not know");
    }
  }
}

void GltfFile::tellExtensions(Notes& notes) const
{
  std::map<std::string, int> counts;
  countExtensions(this->Json, counts);
  for (const auto& [name, count] : counts)
  {
    if (ReadExtensions.count(name) == 0)
    {
      notes.push_back(
          {"extension " + asUtf8(oneLine(name)), "left out", "it is not read (" + std::to_string(count) + " uses)"});
    }
  }
}

const std::vector<JsonCursor>& GltfFile::section(const std::string& name) const
{
  const auto known = this->Sections.find(name);
  if (known != this->Sections.end())
  {
    return known->second;
  }
  const auto section = this->root().find(name.c_str());
  std::vector<JsonCursor> items = section ? section->items() : std::vector<JsonCursor>();
  for (const JsonCursor& item : items)
  {
    item.members();  // be an object
  }
  return this->Sections[name] = std::move(items);
}

std::size_t GltfFile::index(const JsonCursor& number, const std::string& section) const
{
  const std::size_t count = this->section(section).size();
  const std::size_t index = wholeNumber(number);
  if (index >= count)
  {
    number.failExpected("the number of one of " + std::to_string(count) + " " + section + ", counted from 0");
  }
  return index;
}

const JsonCursor& GltfFile::element(const JsonCursor& number, const std::string& section) const
{
  return this->section(section)[this->index(number, section)];
}

const std::string& GltfFile::resolve(const JsonCursor& uri) const
{
  const std::string text = uri.string();
  const auto known = this->Loaded.find(text);
  if (known != this->Loaded.end())
  {
    return known->second;
  }
  std::string content;
  if (text.compare(0, 5, "data:") == 0)
  {
    const std::size_t comma = text.find(";base64,");
    if (comma == std::string::npos || comma > 200)
    {
      uri.fail("a data URI that is not base64; expected data:TYPE;base64,...");
    }
    content = decodeBase64(uri, text, comma + 8);
  }
  else
  {
    const std::string folder = std::filesystem::path(this->Path).parent_path().string();
    content = readFile(resolvePath(folder, decodePercent(text), this->FileNotes), uri.where());
  }
  return this->Loaded[text] = std::move(content);
}

Bytes GltfFile::buffer(std::size_t index) const
{
  const JsonCursor& buffer = this->section("buffers")[index];
  const std::size_t length = wholeNumber(buffer.at("byteLength"));
  Bytes bytes = this->Chunk;
  if (const auto uri = buffer.find("uri"))
  {
    const std::string& content = this->resolve(*uri);
    bytes = {reinterpret_cast<const unsigned char*>(content.data()), content.size()};
  }
  else if (index != 0 || !this->HasChunk)
  {
    buffer.fail("neither a \"uri\" nor the binary chunk of a .glb; expected one of them");
  }
  if (bytes.size < length)
  {
    buffer.fail(std::to_string(bytes.size) + " bytes; expected " + std::to_string(length));
  }
  return {bytes.data, length};
}

Bytes GltfFile::view(const JsonCursor& view) const
{
  const Bytes buffer = this->buffer(this->index(view.at("buffer"), "buffers"));
  const auto offset = view.find("byteOffset");
  const std::size_t begin = offset ? wholeNumber(*offset) : 0;
  const std::size_t length = wholeNumber(view.at("byteLength"));
  if (begin > buffer.size || length > buffer.size - begin)
  {
    view.fail("ends at byte " + std::to_string(begin + length) + " of a buffer of " + std::to_string(buffer.size) +
              "; expected a view inside");
  }
  return {buffer.data + begin, length};
}

Bytes GltfFile::image(const JsonCursor& image) const
{
  if (const auto view = image.find("bufferView"))
  {
    return this->view(this->element(*view, "bufferViews"));
  }
  const std::string& content = this->resolve(image.at("uri"));
  return {reinterpret_cast<const unsigned char*>(content.data()), content.size()};
}

std::size_t wholeNumber(const JsonCursor& number)
{
  const double value = number.numberAtLeast(0.0);
  if (value != std::floor(value) || value > 9007199254740992.0)
  {
    number.failExpected("a whole number");
  }
  return static_cast<std::size_t>(value);
}
}  // namespace kalos::scene
