// SPDX-License-Identifier: BSD-3-Clause
/** What a reader chose or approximated. It becomes part of the audit of every solve. */
#ifndef KalosNotes_h
#define KalosNotes_h

#include <string>
#include <vector>

namespace kalos::scene
{
struct Note
{
  std::string subject;
  std::string choice;
  std::string reason;
};

using Notes = std::vector<Note>;
}  // namespace kalos::scene

#endif
