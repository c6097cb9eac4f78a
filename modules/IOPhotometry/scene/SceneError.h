// SPDX-License-Identifier: BSD-3-Clause
/** What went wrong in an input file: thrown while reading, caught once, in the reader's RequestData. */
#ifndef KalosSceneError_h
#define KalosSceneError_h

#include <stdexcept>
#include <string>

namespace kalos::scene
{
/** The message is `FILE: WHERE: what is wrong and what is expected`; FILE is filled in by whoever knows it. */
class SceneError : public std::runtime_error
{
public:
  SceneError(const std::string& where, const std::string& what) : std::runtime_error(where + ": " + what) {}
  SceneError(const std::string& file, const std::string& where, const std::string& what)
      : std::runtime_error(file + ": " + where + ": " + what), HasFile(true)
  {
  }

  std::string Message(const std::string& file) const
  {
    return this->HasFile ? this->what() : file + ": " + this->what();
  }

private:
  bool HasFile = false;
};
}  // namespace kalos::scene

#endif
