// SPDX-License-Identifier: BSD-3-Clause
/** Counts notes that are the same for several objects of a file, and keeps the first names. */
#ifndef KalosNoteCounter_h
#define KalosNoteCounter_h

#include <map>
#include <string>
#include <tuple>

#include "InputError.h"
#include "Names.h"
#include "Notes.h"

namespace kalos::scene
{
class NoteCounter
{
public:
  /** The destructor adds the counts to `notes`. */
  explicit NoteCounter(Notes& notes) : Found(notes) {}
  NoteCounter(const NoteCounter&) = delete;
  void operator=(const NoteCounter&) = delete;
  ~NoteCounter()
  {
    for (const auto& [what, whose] : this->Counted)
    {
      const auto& [subject, choice, reason] = what;
      const std::string more = whose.first > 3 ? ", ..." : "";
      this->Found.push_back(
          {subject, choice, reason + " (" + std::to_string(whose.first) + ": " + whose.second + more + ")"});
    }
  }

  void count(const std::string& subject, const std::string& name, const std::string& choice, const std::string& reason)
  {
    auto& [count, names] = this->Counted[{subject, choice, reason}];
    if (++count <= 3)
    {
      names += (count > 1 ? ", " : "") + asUtf8(oneLine(name));
    }
  }

private:
  Notes& Found;
  std::map<std::tuple<std::string, std::string, std::string>, std::pair<int, std::string>> Counted;
};
}  // namespace kalos::scene

#endif
