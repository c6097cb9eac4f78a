// SPDX-License-Identifier: BSD-3-Clause
/**
 * A glTF 2.0 file, .gltf or .glb: its JSON, its buffers, and references between its parts. VTK's loader
 * crashes on invalid files; tinygltf accepts references and views that do not exist, and names no place in its errors.
 */
#ifndef KalosGltfFile_h
#define KalosGltfFile_h

#include <map>
#include <string>
#include <vector>

#include "../base/JsonCursor.h"
#include "../base/Notes.h"

namespace kalos::scene
{
/** Bytes inside a buffer of the file; valid as long as the file is. */
struct Bytes
{
  const unsigned char* data = nullptr;
  std::size_t size = 0;
};

class GltfFile
{
public:
  /** Read the file at `path`; throws InputError. Buffers are read when they are needed; `notes` gets
   * base/FilePaths.h's. */
  GltfFile(const std::string& path, Notes& notes);
  GltfFile(const GltfFile&) = delete;
  void operator=(const GltfFile&) = delete;

  JsonCursor root() const { return JsonCursor(this->Json, "scene"); }
  /** The elements of a top-level array, such as "nodes"; none if it is absent. */
  const std::vector<JsonCursor>& section(const std::string& name) const;
  /** The index that `number` holds, of an element of a section. */
  std::size_t index(const JsonCursor& number, const std::string& section) const;
  const JsonCursor& element(const JsonCursor& number, const std::string& section) const;

  /** The bytes of a buffer view. */
  Bytes view(const JsonCursor& view) const;
  /** Adds a note for each extension that is not read, with the number of its uses. */
  void tellExtensions(Notes& notes) const;
  /** The bytes that "uri" or "bufferView" of an image name. */
  Bytes image(const JsonCursor& image) const;

private:
  const std::string& resolve(const JsonCursor& uri) const;
  Bytes buffer(std::size_t index) const;

  std::string Path;
  Notes& FileNotes;
  std::string Content;  ///< of the whole file, if it is a .glb
  Bytes Chunk;          ///< the binary chunk of a .glb
  bool HasChunk = false;
  nlohmann::json Json;
  mutable std::map<std::string, std::vector<JsonCursor>> Sections;
  mutable std::map<std::string, std::string> Loaded;  ///< by uri
};

/** A whole number from 0 to 2^53. */
std::size_t wholeNumber(const JsonCursor& number);
}  // namespace kalos::scene

#endif
