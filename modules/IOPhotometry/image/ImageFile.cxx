// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFile.h"

#include <exception>
#include <stdexcept>

#include "../TemporaryFile.h"

namespace kalos
{
ImageFileError writeImageFile(const char* fileName, const char* suffix, vtkImageData* image,
                              const std::function<void(const std::string&, const std::vector<Plane>&)>& write)
{
  if (!fileName || !*fileName)
  {
    return {vtkErrorCode::NoFileNameError,
            std::string("image: FileName: not set; expected the path of an ") + suffix + " file"};
  }
  const std::string file = std::string(fileName) + ": ";
  try
  {
    const std::vector<Plane> planes = makePlanes(image);
    const TemporaryFile temporary(fileName);
    write(temporary.path(), planes);
    temporary.moveIntoPlace();
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return {vtkErrorCode::FileFormatError, file + error.what()};
  }
  catch (const std::exception&)
  {
    // The library's message names the temporary file, so it is not passed on.
    return {vtkErrorCode::CannotOpenFileError,
            file + "file: cannot be written; expected a writable folder with room on the disk"};
  }
}
}  // namespace kalos
