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
  std::error_code ignored;
  std::string spelled = path;
  std::replace(spelled.begin(), spelled.end(), '\\', '/');
  if (!std::filesystem::exists(std::filesystem::path(folder) / spelled, ignored) ||
      std::filesystem::exists(std::filesystem::path(folder) / path, ignored))
  {
    spelled = path;
  }
  const std::filesystem::path whole = std::filesystem::path(folder) / spelled;
  const std::filesystem::path normal = std::filesystem::path(spelled).lexically_normal();
  if (normal.is_absolute() || (!normal.empty() && *normal.begin() == ".."))
  {
    notes.push_back({Subject, whole.lexically_normal().string(), {}});
  }
  return whole.string();
}

std::optional<std::string> findFile(const std::string& folder, const std::string& path, Notes& notes)
{
  Notes elsewhere;
  const std::string found = resolvePath(folder, path, elsewhere);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(found, ignored))
  {
    return {};
  }
  notes.insert(notes.end(), elsewhere.begin(), elsewhere.end());
  return found;
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
