// SPDX-License-Identifier: BSD-3-Clause
// Emitters that a pilot prefers, in direct light; see estimator/direct/DirectLight.h.
#include "estimator/direct/DirectLight.h"

namespace kalos
{
void DirectLight::prefer(const Emission& emission)
{
  if (!emission.isGuided())
    return;
  const std::vector<double>& factors = emission.preference().factors;
  const std::size_t rectangles = this->LuminaireOf.size();
  for (std::size_t i = 0; i < this->Areas.size(); ++i)
  {
    this->Areas[i].factor = factors[i < rectangles ? this->LuminaireOf[i] : emission.luminaires() + i - rectangles];
    this->HasSampledAreas = this->HasSampledAreas || !this->Areas[i].isInClosedForm();
  }
  for (std::size_t i = 0; i < emission.luminaires(); ++i)
    this->Factors.push_back(static_cast<float>(factors[i]));
}
}  // namespace kalos
