// SPDX-License-Identifier: BSD-3-Clause
/** What the writers of image files have in common: checks, a file that is whole or not there, one line an error. */
#ifndef KalosImageFile_h
#define KalosImageFile_h

#include <functional>
#include <string>
#include <vector>

#include "LuminancePlanes.h"
#include "vtkErrorCode.h"

namespace kalos
{
struct ImageFileError
{
  unsigned long code = vtkErrorCode::NoError;
  std::string message;  ///< empty if the file was written
};

/** Calls `write(path, planes)` for a path beside `fileName` and moves what it makes there into place. */
ImageFileError writeImageFile(const char* fileName, const char* suffix, vtkImageData* image,
                              const std::function<void(const std::string&, const std::vector<Plane>&)>& write);
}  // namespace kalos

#endif
