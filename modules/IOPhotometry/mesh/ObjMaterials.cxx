// SPDX-License-Identifier: BSD-3-Clause
#include "ObjMaterials.h"

#include <algorithm>
#include <filesystem>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/TextLines.h"
#include "../material/MtlFile.h"

namespace kalos::scene
{
namespace
{
/** A name up to a blank and `#`, where some write a comment. */
std::string withoutComment(const std::string& name)
{
  return std::string(trimmed(std::string_view(name).substr(0, name.find(" #"))));
}

/** The material of exactly this name, else of the name without a trailing comment. */
const Material* lookUp(const Materials& materials, const std::string& name)
{
  for (const std::string& spelled : {name, withoutComment(name)})
  {
    const auto found = materials.find(spelled);
    if (found != materials.end())
    {
      return &found->second;
    }
  }
  const auto same = [&](const auto& entry) { return withoutComment(entry.first) == name; };
  const auto found = std::find_if(materials.begin(), materials.end(), same);
  return found == materials.end() ? nullptr : &found->second;
}

/** The libraries of one statement: its whole text if there is such a file, else its words. */
std::vector<std::string> splitLibraries(const std::string& folder, const std::string& text)
{
  Notes ignored;
  if (findFile(folder, text, ignored))
  {
    return {text};
  }
  std::vector<std::string> names;
  Words words(text);
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
  {
    names.emplace_back(word);
  }
  return names;
}

/** All libraries that are there, in one; `missing` names those that are not. */
Materials readLibraries(const std::string& path, const ObjFile& file, Notes& notes, std::string& missing)
{
  Materials all;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  for (const std::string& text : file.libraries)
  {
    for (const std::string& name : splitLibraries(folder, text))
    {
      if (const auto library = findFile(folder, name, notes))
      {
        all.merge(readMtlFile(*library, notes));
      }
      else
      {
        missing += " (there is no " + quotable(name) + ")";
      }
    }
  }
  return all;
}
}  // namespace

void useObjMaterials(const std::string& path, ObjFile& file, const Materials& overrides, bool required, Notes& notes)
{
  const auto given = [&](const std::string& name) { return lookUp(overrides, name) != nullptr; };
  Materials own;
  std::string missing;
  if (!std::all_of(file.materialNames.begin(), file.materialNames.end(), given))
  {
    own = readLibraries(path, file, notes, missing);
  }
  NoteCounter found(notes);
  std::vector<std::int32_t> numbers;
  for (const std::string& name : file.materialNames)
  {
    const Material* material = given(name) ? lookUp(overrides, name) : lookUp(own, name);
    if (!material && required)
    {
      throw InputError(
          path, "usemtl " + quotable(name),
          "no such material in the scene; expected a name from \"materials\" or of a library of the file" + missing);
    }
    if (!material)
    {
      found.count("materials that are defined nowhere", name, "as surfaces without a material",
                  "neither the scene nor a library of the file has them" + missing);
      numbers.push_back(-1);
      continue;
    }
    numbers.push_back(static_cast<std::int32_t>(file.polygons.palette.size()));
    file.polygons.palette.push_back(*material);
  }
  for (std::int32_t& material : file.polygons.materialOf)
  {
    material = material < 0 ? -1 : numbers[material];
  }
}
}  // namespace kalos::scene
