// SPDX-License-Identifier: BSD-3-Clause
#include "ObjMaterials.h"

#include <algorithm>
#include <filesystem>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../material/MtlFile.h"

namespace kalos::scene
{
namespace
{
/** All libraries that are there, in one; `missing` names those that are not. */
Materials readLibraries(const std::string& path, const ObjFile& file, Notes& notes, std::string& missing)
{
  Materials all;
  for (const std::string& name : file.libraries)
  {
    const std::string library = resolvePath(std::filesystem::path(path).parent_path().string(), name, notes);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(library, ignored))
    {
      all.merge(readMtlFile(library, notes));
    }
    else
    {
      missing += " (there is no " + quotable(name) + ")";
    }
  }
  return all;
}
}  // namespace

std::vector<Material> findObjMaterials(const std::string& path, const ObjFile& file, const Materials& overrides,
                                       Notes& notes)
{
  const auto given = [&](const std::string& name) { return overrides.count(name) > 0; };
  Materials own;
  std::string missing;
  if (!std::all_of(file.materialNames.begin(), file.materialNames.end(), given))
  {
    own = readLibraries(path, file, notes, missing);
  }
  std::vector<Material> materials;
  for (const std::string& name : file.materialNames)
  {
    const Materials& from = given(name) ? overrides : own;
    const auto found = from.find(name);
    if (found == from.end())
    {
      throw InputError(
          path, "usemtl " + quotable(name),
          "no such material in the scene; expected a name from \"materials\" or of a library of the file" + missing);
    }
    materials.push_back(found->second);
  }
  return materials;
}
}  // namespace kalos::scene
