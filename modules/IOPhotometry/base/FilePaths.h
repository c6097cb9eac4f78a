// SPDX-License-Identifier: BSD-3-Clause
/**
 * Paths in scenes, models and material libraries. A path is relative to the folder of the file that names it. Absolute
 * paths, `..` and symbolic links are followed, because libraries of luminaires are often kept elsewhere; the audit
 * lists every file that was read from outside that folder.
 */
#ifndef KalosFilePaths_h
#define KalosFilePaths_h

#include <optional>
#include <string>

#include "Notes.h"

namespace kalos::scene
{
/** Resolves `path` against `folder`; a file outside the folder is added to `notes`. Backslashes are read as slashes if
 * only that names a file. */
std::string resolvePath(const std::string& folder, const std::string& path, Notes& notes);

/** The same for an existing file. Empty if there is no such file. */
std::optional<std::string> findFile(const std::string& folder, const std::string& path, Notes& notes);

/** Joins the notes about files elsewhere into one. */
Notes joinFilesElsewhere(const Notes& notes);
}  // namespace kalos::scene

#endif
