// SPDX-License-Identifier: BSD-3-Clause
// What a filter that has caught an exception answers to GetErrorCode().
#ifndef ErrorCodes_h
#define ErrorCodes_h

#include <exception>
#include <stdexcept>

#include "vtkErrorCode.h"

/// UserError for input or settings that cannot be used, UnknownError for what went wrong in the work itself.
inline unsigned long ErrorCodeOf(const std::exception& error)
{
  const bool input = dynamic_cast<const std::invalid_argument*>(&error) != nullptr;
  return input ? vtkErrorCode::UserError : vtkErrorCode::UnknownError;
}

#endif
