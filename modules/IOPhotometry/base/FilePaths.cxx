// SPDX-License-Identifier: BSD-3-Clause
#include "FilePaths.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "InputError.h"
#include "Names.h"

namespace kalos::scene
{
namespace
{
const char* const Subject = "files elsewhere";
}  // namespace

std::string resolvePath(const std::string& folder, const std::string& path, Notes& notes)
{
  const std::filesystem::path whole = std::filesystem::path(folder) / path;
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  if (normal.is_absolute() || (!normal.empty() && *normal.begin() == ".."))
  {
    notes.push_back({Subject, whole.lexically_normal().string(), {}});
  }
  return whole.string();
}

std::optional<std::string> findFile(const std::string& folder, const std::string& path, Notes& notes)
{
  std::string slashed = path;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  for (const std::string& name : {path, slashed})
  {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(std::filesystem::path(folder) / name, ignored))
    {
      return resolvePath(folder, name, notes);
    }
  }
  return {};
}

Notes joinFilesElsewhere(const Notes& notes)
{
  Notes joined;
  std::set<std::string> elsewhere;
  for (const Note& note : notes)
  {
    if (note.subject == Subject)
    {
      elsewhere.insert(asUtf8(oneLine(note.choice)));
    }
    else
    {
      joined.push_back(note);
    }
  }
  std::string names;
  for (const std::string& name : elsewhere)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!elsewhere.empty())
  {
    joined.push_back(
        {Subject, std::to_string(elsewhere.size()) + " read",
         "named by a path that is absolute or leads out of the folder of the file that names it: " + names});
  }
  return joined;
}
}  // namespace kalos::scene
