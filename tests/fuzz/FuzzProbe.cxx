// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for tables of receivers: an error of one line, or points with unit normals.
#include "FuzzFile.h"
#include "base/InputError.h"
#include "scene/ProbeFile.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  constexpr std::int64_t most = 100;
  const std::string path = fuzz::write("probe.csv", data, size);
  const nlohmann::json name = "probe.csv";
  try
  {
    const auto points = kalos::scene::readProbeFile(kalos::scene::JsonCursor(name, "points"), path, most);
    const vtkIdType count = points->GetNumberOfPoints();
    vtkDataArray* normals = points->GetPointData()->GetNormals();
    fuzz::require(count > 0 && count <= most && points->GetNumberOfVerts() == count &&
                  normals->GetNumberOfTuples() == count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* n = normals->GetTuple3(i);
      fuzz::require(std::abs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-12);
      for (int c = 0; c < 3; ++c)
        fuzz::require(std::isfinite(points->GetPoint(i)[c]));
    }
  }
  catch (const kalos::scene::InputError& error)
  {
    const std::string message = error.what();
    fuzz::require(message.find('\n') == std::string::npos && message.compare(0, path.size(), path) == 0);
  }
  return 0;
}
