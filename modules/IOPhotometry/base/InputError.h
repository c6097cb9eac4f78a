// SPDX-License-Identifier: BSD-3-Clause
/** An error in an input file, thrown while reading and caught once, in the reader's RequestData. */
#ifndef KalosInputError_h
#define KalosInputError_h

#include <algorithm>
#include <stdexcept>
#include <string>

namespace kalos::scene
{
/** Replaces line breaks and other control characters by question marks. */
inline std::string oneLine(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return text;
}

/** Makes bytes of a damaged file printable: at most 40, with question marks for those that are not ASCII. */
inline std::string quotable(std::string text)
{
  text = text.substr(0, 40);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c > 126; }, '?');
  return text;
}

/** The message is `FILE: WHERE: what is wrong and what is expected`; the caller that knows FILE fills it in. */
class InputError : public std::runtime_error
{
public:
  InputError(const std::string& where, const std::string& what) : std::runtime_error(oneLine(where + ": " + what)) {}
  InputError(const std::string& file, const std::string& where, const std::string& what)
      : std::runtime_error(oneLine(file + ": " + where + ": " + what)), HasFile(true)
  {
  }

  /** The same with its file filled in, unless it has one. */
  InputError in(const std::string& file) const
  {
    return this->HasFile ? *this : InputError(oneLine(file + ": " + this->what()));
  }

  std::string message(const std::string& file) const
  {
    return this->HasFile ? this->what() : file + ": " + this->what();
  }

private:
  explicit InputError(const std::string& complete) : std::runtime_error(complete), HasFile(true) {}

  bool HasFile = false;
};
}  // namespace kalos::scene

#endif
