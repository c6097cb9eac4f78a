// SPDX-License-Identifier: BSD-3-Clause
/** Checks the header of an OpenEXR file first, because the library allocates whatever a damaged header asks for. */
#ifndef KalosExrHeader_h
#define KalosExrHeader_h

#include <string>

namespace kalos
{
/**
 * Empty if every attribute of the headers lies within the file, and the data window has 1 to `mostPixels` pixels that
 * the file can hold, even all alike and compressed; else what is wrong and what is expected.
 */
std::string checkExrHeader(const std::string& path, double mostPixels);
}  // namespace kalos

#endif
