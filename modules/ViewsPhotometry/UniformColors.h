// SPDX-License-Identifier: BSD-3-Clause
/** A perceptually uniform colour table from black-blue over red to light yellow. */
#ifndef KalosUniformColors_h
#define KalosUniformColors_h

#include <array>

namespace kalos
{
using Rgb = std::array<double, 3>;  ///< sRGB, [0,1]

/**
 * 256 colours along a curve in Oklab (Ottosson 2020): lightness rises steadily, the hue turns from blue over red to
 * yellow, chroma stays within what sRGB can show; steps are of equal length in Oklab, so that equal differences of the
 * quantity look equally large.
 */
const std::array<Rgb, 256>& uniformColors();
}  // namespace kalos

#endif
