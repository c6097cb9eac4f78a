// SPDX-License-Identifier: BSD-3-Clause
/** Turns names of a model, which may be anything, into names for results. */
#ifndef KalosNames_h
#define KalosNames_h

#include <algorithm>
#include <set>
#include <string>

namespace kalos::scene
{
/** Bytes that are not UTF-8 become question marks: an OBJ may be in any encoding. */
inline std::string asUtf8(std::string text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
    const unsigned int lead = byte(i);
    std::size_t more = lead < 0x80 ? 0 : lead >= 0xC2 && lead < 0xE0 ? 1 : lead >= 0xE0 && lead < 0xF0 ? 2 : 3;
    bool good = lead < 0x80 || (lead >= 0xC2 && lead < 0xF4);
    for (std::size_t k = 1; k <= more; ++k)
    {
      good = good && byte(i + k) >= 0x80 && byte(i + k) < 0xC0;
    }
    text[i] = good ? text[i] : '?';
    i += good ? more : 0;
  }
  return text;
}

/**
 * The wish, or `absent` if it is empty, without characters that file names cannot have, and with a number if it is
 * among `taken`, where it is added.
 */
inline std::string freeName(std::string wish, const char* absent, std::set<std::string>& taken)
{
  wish = wish.empty() ? absent : asUtf8(wish.substr(0, 100));
  std::replace_if(
      wish.begin(), wish.end(), [](unsigned char c) { return c < ' ' || c == 127 || c == '/' || c == '\\'; }, '-');
  wish[0] = wish[0] == '.' ? '-' : wish[0];
  if (taken.insert(wish).second)
  {
    return wish;
  }
  // Numbers mostly run on: look for the end of their row by doubling and halving.
  const auto numbered = [&wish](int i) { return wish + " " + std::to_string(i); };
  int used = 1, free = 2;
  while (taken.count(numbered(free)) > 0)
  {
    used = free;
    free *= 2;
  }
  while (free - used > 1)
  {
    const int middle = used + (free - used) / 2;
    (taken.count(numbered(middle)) > 0 ? used : free) = middle;
  }
  taken.insert(numbered(free));
  return numbered(free);
}
}  // namespace kalos::scene

#endif
