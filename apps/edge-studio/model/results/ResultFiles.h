// SPDX-License-Identifier: BSD-3-Clause
// Stores results in VTK files with all their arrays. Each function throws Problem.
#ifndef studio_ResultFiles_h
#define studio_ResultFiles_h

#include "results/Result.h"

namespace studio
{
/// To NAME.vtm, and the folder NAME beside it. Of receivers.
void writeResult(const Result& result, const QString& path);
ResultPtr readResult(const MethodSettings& settings, bool complete, const QString& path);

/// To NAME.vti. Of a camera.
void writeImage(const Result& image, const QString& path);
ResultPtr readImage(const MethodSettings& settings, const QString& path);
}  // namespace studio

#endif
