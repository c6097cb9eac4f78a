// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/control/Techniques.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace kalos
{
namespace
{
struct Name
{
  Technique technique;
  const char* name;
};

constexpr Name known[] = {{Technique::Stratified, "stratified"},
                          {Technique::Picked, "picked"},
                          {Technique::Convex, "convex"},
                          {Technique::Near, "near"},
                          {Technique::Paths, "paths"},
                          {Technique::Neighbours, "neighbours"},
                          {Technique::Effort, "effort"},
                          {Technique::Highlights, "highlights"},
                          {Technique::ExactDirect, "exact-direct"}};

template <class Condition>
std::string list(const char* separator, const Condition& condition)
{
  std::string names;
  for (const Name& n : known)
    if (condition(n.technique))
      names += (names.empty() ? "" : separator) + std::string(n.name);
  return names;
}
}  // namespace

TechniqueSet TechniqueSet::named(const std::string& names)
{
  TechniqueSet set;
  std::istringstream words(names);
  for (std::string word; std::getline(words, word, ',');)
  {
    const auto* found = std::find_if(std::begin(known), std::end(known), [&](const Name& n) { return word == n.name; });
    if (found == std::end(known))
      throw std::invalid_argument("disable: '" + word + "' is not a technique, expected some of " +
                                  list(", ", [](Technique) { return true; }));
    set.insert(found->technique);
  }
  return set;
}

std::string TechniqueSet::names() const
{
  return list(",", [this](Technique t) { return this->contains(t); });
}
}  // namespace kalos
