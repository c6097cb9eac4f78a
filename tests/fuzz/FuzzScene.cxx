// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for scene files: an error of one line, or a scene. Files that a scene may name lie beside it.
#include "SceneCheck.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const bool prepared = [] {
    fuzz::write("room.obj", "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl white\nf 1 2 3\n");
    fuzz::write("room.mtl", "newmtl white\nKd 0.5 0.5 0.5\n");
    fuzz::write("probe.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n");
    fuzz::write("spot.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n300 5\n");
    return true;
  }();
  static_cast<void>(prepared);
  fuzz::checkScene(fuzz::write("scene.json", data, size));
  return 0;
}
