// SPDX-License-Identifier: BSD-3-Clause
/** The statements of a material library, before they are converted to materials. */
#ifndef KalosMtlStatements_h
#define KalosMtlStatements_h

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace kalos::scene
{
/** The statements of one newmtl, by keyword in small letters; the last of a keyword counts. */
class MtlEntry
{
public:
  MtlEntry(std::string called, const std::string& path) : name(std::move(called)), Path(path) {}

  std::string name;

  void add(const std::string& keyword, const std::string& text, long long line)
  {
    this->Statements[keyword] = {text, line};
  }
  bool has(const std::string& keyword) const { return this->Statements.count(keyword) > 0; }
  /** A number from 0 to `highest`, or `absent`. An option before it, as in `d -halo 0.5`, is passed over. */
  double number(const std::string& keyword, double absent, double highest = std::numeric_limits<double>::max()) const;
  /** Three such numbers; a single one serves all three. */
  std::array<double, 3> color(const std::string& keyword, double absent,
                              double highest = std::numeric_limits<double>::max()) const;
  /** The name of a texture, which options may precede; empty without one. */
  std::string file(const std::string& keyword) const;

private:
  struct Statement
  {
    std::string text;
    long long line = 0;
  };

  [[noreturn]] void fail(const Statement& statement, double highest) const;

  std::string Path;
  std::map<std::string, Statement> Statements;
};

/** Throws InputError for a newmtl without a name. */
std::vector<MtlEntry> readMtlStatements(const std::string& path);
}  // namespace kalos::scene

#endif
