// SPDX-License-Identifier: BSD-3-Clause
// Results as files that other programs read.
#ifndef studio_Export_h
#define studio_Export_h

#include "results/Result.h"

namespace studio
{
/// The files that exportResult() writes.
QStringList exportedFiles(const Result& result, const QString& folder);

/// For each receiver set NAME.csv, as the command `kalos solve` writes it, and NAME.vtp, into a folder that exists or
/// is made. Returns the paths. Throws Problem.
QStringList exportResult(const Result& result, const QString& folder);

/// An image of luminance as OpenEXR, float32, in cd/m2, as vtkKalosEXRWriter writes it. Throws Problem.
void exportImage(const Result& image, const QString& path);
}  // namespace studio

#endif
