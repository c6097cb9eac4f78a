// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which files a file may name. A path is relative to the folder of the file that names it, a scene, a model or a
 * library of materials; absolute paths, `..` and symbolic links are followed for reading, as libraries of luminaires
 * lie where they lie. But no surprise: the audit names every file that is not in or below that folder by the path as it
 * stands.
 */
#ifndef KalosFilePaths_h
#define KalosFilePaths_h

#include <optional>
#include <string>

#include "Notes.h"

namespace kalos::scene
{
/** The file called `path` in a file of `folder`; one that lies elsewhere is added to `notes`. */
std::string resolvePath(const std::string& folder, const std::string& path, Notes& notes);

/** The same for a regular file, with slashes for backslashes if that is where it is; none if it is nowhere. */
std::optional<std::string> findFile(const std::string& folder, const std::string& path, Notes& notes);

/** `notes` with all files that lie elsewhere in one. */
Notes joinFilesElsewhere(const Notes& notes);
}  // namespace kalos::scene

#endif
