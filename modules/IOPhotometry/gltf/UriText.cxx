// SPDX-License-Identifier: BSD-3-Clause
#include "UriText.h"

#include <cctype>
#include <cstring>

namespace kalos::scene
{
namespace
{
int sextet(unsigned char c)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char* found = c ? std::strchr(digits, c) : nullptr;
  return found ? static_cast<int>(found - digits) : -1;
}
}  // namespace

std::string decodeBase64(const JsonCursor& uri, const std::string& text, std::size_t begin)
{
  std::string bytes;
  unsigned int bits = 0;
  int count = 0;
  for (std::size_t i = begin; i < text.size() && text[i] != '='; ++i)
  {
    const int digit = sextet(static_cast<unsigned char>(text[i]));
    if (digit < 0)
    {
      uri.fail("a character that is not of base64; expected letters, digits, + and /");
    }
    bits = (bits << 6 | static_cast<unsigned int>(digit)) & 0xFFFFU;
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<char>(bits >> count & 0xFFU));
    }
  }
  return bytes;
}

std::string decodePercent(const std::string& text)
{
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool escape = text[i] == '%' && i + 2 < text.size() &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    decoded.push_back(escape ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i]);
    i += escape ? 2 : 0;
  }
  return decoded;
}
}  // namespace kalos::scene
