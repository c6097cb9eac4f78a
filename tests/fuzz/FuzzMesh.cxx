// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for meshes, PLY, STL and OFF, text or binary, as the only surface of a scene and to be repaired. VTP
// is VTK's to read.
#include <cstring>

#include "SceneCheck.h"
#include "vtkKalosMeshReader.h"
#include "vtkNew.h"

namespace
{
void writeScene(const std::string& type)
{
  fuzz::write(type + ".json", R"({"kalos": 1, "materials": {"m": {"reflectance": 0.5}},
    "receivers": [{"name": "p", "plane": {"origin": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 0], "resolution": [1, 1]}}],
    "surfaces": [{"name": "s", "material": "m", "file": "mesh.)" +
                                  type + "\"}]}");
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const bool prepared = [] {
    writeScene("ply");
    writeScene("stl");
    writeScene("off");
    return true;
  }();
  static_cast<void>(prepared);
  const auto startsWith = [&](const char* word) { return size >= 3 && std::memcmp(data, word, 3) == 0; };
  const std::string type = startsWith("ply") ? "ply" : startsWith("OFF") ? "off" : "stl";
  fuzz::write("mesh." + type, data, size);
  fuzz::checkScene((fuzz::folder() / (type + ".json")).string());
  vtkNew<vtkKalosMeshReader> reader;
  reader->SetFileName((fuzz::folder() / ("mesh." + type)).string().c_str());
  reader->Update();
  return 0;
}
