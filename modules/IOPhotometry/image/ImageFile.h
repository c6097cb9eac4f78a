// SPDX-License-Identifier: BSD-3-Clause
/** The frame of the image writers: checks, atomic replacement of the file, one-line errors. */
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

/** Calls `write(path, planes)` with a temporary path and then moves that file to `fileName`. */
ImageFileError writeImageFile(const char* fileName, const char* suffix, vtkImageData* image,
                              const std::function<void(const std::string&, const std::vector<Plane>&)>& write);
}  // namespace kalos

#endif
