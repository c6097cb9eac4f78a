// SPDX-License-Identifier: BSD-3-Clause
// What a surface sends to every side: L = sum over the bands of share (rho E + M0)/pi, cd/m2.
#ifndef studio_DiffuseLuminance_h
#define studio_DiffuseLuminance_h

class vtkDataSet;

namespace studio
{
/// Adds the arrays Luminance, LuminanceStandardError and, for n > 1 bands, LuminanceBands to cells that have
/// Reflectance and Illuminance. Gloss and mirrors depend on the eye and are not in it. The error is that of a grey of
/// the same diffuse luminance.
void addDiffuseLuminance(vtkDataSet* dataSet);
}  // namespace studio

#endif
