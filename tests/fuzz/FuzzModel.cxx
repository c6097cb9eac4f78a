// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for models: glTF, text or binary, and OBJ, which may name itself as its material library.
#include <cstring>

#include "SceneCheck.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
  const char* name = binary ? "model.glb" : size > 0 && data[0] == '{' ? "model.gltf" : "model.obj";
  fuzz::checkScene(fuzz::write(name, data, size));
  return 0;
}
