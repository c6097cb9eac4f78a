// SPDX-License-Identifier: BSD-3-Clause
/**
 * A position in a JSON document. It knows its path (`materials.white.reflectance`); asking for a value of another type
 * or range throws an InputError that names the path and what is expected.
 */
#ifndef KalosJsonCursor_h
#define KalosJsonCursor_h

#include <array>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>
#include "Vectors.h"

namespace kalos::scene
{
constexpr int MaximumDepth = 32;               ///< of nested objects and arrays in a scene file
constexpr std::size_t MaximumBytes = 1 << 26;  ///< size of a scene file
constexpr int MaximumBands = 256;              ///< components of a reflectance

/** Parse a text; malformed JSON, duplicate keys and too deep nesting throw. */
nlohmann::json parseJson(const std::string& text);

class JsonCursor
{
public:
  /** `json` must outlive the cursor. */
  JsonCursor(const nlohmann::json& json, std::string where) : Json(&json), Place(std::move(where)) {}

  const std::string& where() const { return this->Place; }
  [[noreturn]] void fail(const std::string& what) const;
  /** Fail with "VALUE found; expected ...". */
  [[noreturn]] void failExpected(const std::string& expected) const;

  /** Checks that this is an object with no other keys than these. */
  void checkKeys(std::initializer_list<const char*> keys) const;
  bool has(const char* key) const;
  JsonCursor at(const char* key) const;
  std::optional<JsonCursor> find(const char* key) const;

  double number() const;
  double numberAbove(double minimum) const;
  double numberAtLeast(double minimum) const;
  /** A reflectance-like number in [0, 1). */
  double fraction() const;
  /** A share of a whole, in (0, 1]. */
  double share() const;
  int integer(int minimum, int maximum) const;
  bool boolean() const;
  std::string string() const;
  Vector3 vector() const;
  Vector3 nonZeroVector() const;
  /** Two whole numbers whose product is limited. */
  std::array<int, 2> resolution() const;
  /** One number, or an array of them: each in [0, below), or from 0 to any finite number. */
  std::vector<double> bands(double below = std::numeric_limits<double>::infinity()) const;

  /** The elements of an array, with WHERE by name if they have one: `surfaces.floor`, else `surfaces[0]`. */
  std::vector<JsonCursor> items() const;
  /** The members of an object. */
  std::vector<std::pair<std::string, JsonCursor>> members() const;
  /** The member "name", checked to be usable as a file name; the caller checks that it is unique. */
  std::string name() const;

private:
  const nlohmann::json* Json;
  std::string Place;
};
}  // namespace kalos::scene

#endif
