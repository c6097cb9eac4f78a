// SPDX-License-Identifier: BSD-3-Clause
/**
 * Candela tables as text, for the point array CandelaTables. Filters such as vtkAppendPolyData keep one field data
 * array of each name, so only one of several tables would survive there; point data is appended completely.
 */
#ifndef vtkKalosCandelaText_h
#define vtkKalosCandelaText_h

#include <charconv>  // for to_chars, from_chars
#include <string>    // for std::string
#include <vector>    // for the numbers

#include "vtkDataArray.h"

namespace vtkKalosCandelaText
{
/** "axis" or "side", the pole, and the tuples (plane, angle, candela), which read back as they are. */
inline std::string Write(vtkDataArray* tuples, bool sidePole)
{
  std::string text = sidePole ? "side" : "axis";
  for (vtkIdType i = 0; i < tuples->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      char number[32];
      text += ' ';
      text.append(number, std::to_chars(number, number + sizeof number, tuples->GetComponent(i, c)).ptr);
    }
  }
  return text;
}

/** The inverse; false for a text that Write() does not make. */
inline bool Read(const std::string& text, std::vector<double>& numbers, bool& sidePole)
{
  sidePole = text.compare(0, 4, "side") == 0;
  if (!sidePole && text.compare(0, 4, "axis") != 0)
  {
    return false;
  }
  numbers.clear();
  const char* at = text.data() + 4;
  const char* const end = text.data() + text.size();
  while (at < end && *at == ' ')
  {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at + 1, end, value);
    if (error != std::errc())
    {
      return false;
    }
    numbers.push_back(value);
    at = next;
  }
  return at == end && !numbers.empty() && numbers.size() % 3 == 0;
}
}  // namespace vtkKalosCandelaText

#endif
