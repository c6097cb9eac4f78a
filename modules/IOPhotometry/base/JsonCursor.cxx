// SPDX-License-Identifier: BSD-3-Clause
#include "JsonCursor.h"

#include <algorithm>
#include <cmath>

#include "InputError.h"

namespace kalos::scene
{
namespace
{
using nlohmann::json;

/** Short form of a value for a message. */
std::string shown(const json& value)
{
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

std::string quoted(std::initializer_list<const char*> keys)
{
  std::string text;
  for (const char* key : keys)
  {
    text += (text.empty() ? "" : ", ") + std::string(key);
  }
  return text;
}

std::string text(double number)
{
  return json(number).dump();
}
}  // namespace

void JsonCursor::fail(const std::string& what) const
{
  throw InputError(this->Place, what);
}

void JsonCursor::failExpected(const std::string& expected) const
{
  this->fail("found " + shown(*this->Json) + "; expected " + expected);
}

void JsonCursor::checkKeys(std::initializer_list<const char*> keys) const
{
  if (!this->Json->is_object())
  {
    this->failExpected("an object with the keys " + quoted(keys));
  }
  for (const auto& member : this->Json->items())
  {
    const bool known = std::any_of(keys.begin(), keys.end(), [&](const char* key) { return member.key() == key; });
    if (!known)
    {
      this->fail("unknown key " + shown(member.key()) + "; expected " + quoted(keys));
    }
  }
}

bool JsonCursor::has(const char* key) const
{
  return this->Json->is_object() && this->Json->contains(key);
}

JsonCursor JsonCursor::at(const char* key) const
{
  if (!this->has(key))
  {
    this->fail("the key \"" + std::string(key) + "\" is missing");
  }
  return JsonCursor(this->Json->at(key), this->Place == "scene" ? std::string(key) : this->Place + "." + key);
}

std::optional<JsonCursor> JsonCursor::find(const char* key) const
{
  return this->has(key) ? std::optional<JsonCursor>(this->at(key)) : std::nullopt;
}

double JsonCursor::number() const
{
  if (!this->Json->is_number())
  {
    this->failExpected("a number");
  }
  return this->Json->get<double>();
}

double JsonCursor::numberAbove(double minimum) const
{
  const double number = this->number();
  if (!(number > minimum))
  {
    this->failExpected("a number above " + text(minimum));
  }
  return number;
}

double JsonCursor::numberAtLeast(double minimum) const
{
  const double number = this->number();
  if (!(number >= minimum))
  {
    this->failExpected("a number of at least " + text(minimum));
  }
  return number;
}

double JsonCursor::fraction() const
{
  const double number = this->number();
  if (!(number >= 0.0 && number < 1.0))
  {
    this->failExpected("a number of at least 0 and below 1");
  }
  return number;
}

double JsonCursor::share() const
{
  const double number = this->number();
  if (!(number > 0.0 && number <= 1.0))
  {
    this->failExpected("a number above 0 and at most 1");
  }
  return number;
}

int JsonCursor::integer(int minimum, int maximum) const
{
  const std::string expected = "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum);
  if (!this->Json->is_number())
  {
    this->failExpected(expected);
  }
  const double number = this->Json->get<double>();
  if (number != std::floor(number) || number < minimum || number > maximum)
  {
    this->failExpected(expected);
  }
  return static_cast<int>(number);
}

bool JsonCursor::boolean() const
{
  if (!this->Json->is_boolean())
  {
    this->failExpected("true or false");
  }
  return this->Json->get<bool>();
}

std::string JsonCursor::string() const
{
  if (!this->Json->is_string())
  {
    this->failExpected("a string");
  }
  return this->Json->get<std::string>();
}

Vector3 JsonCursor::vector() const
{
  if (!this->Json->is_array() || this->Json->size() != 3 ||
      !std::all_of(this->Json->begin(), this->Json->end(), [](const json& value) { return value.is_number(); }))
  {
    this->failExpected("three numbers [x, y, z]");
  }
  return {(*this->Json)[0].get<double>(), (*this->Json)[1].get<double>(), (*this->Json)[2].get<double>()};
}

Vector3 JsonCursor::nonZeroVector() const
{
  const Vector3 vector = this->vector();
  if (vector == Vector3{})
  {
    this->failExpected("a direction, not zero");
  }
  return vector;
}

std::array<int, 2> JsonCursor::resolution() const
{
  constexpr double maximum = 1e8;
  const std::string expected = "two whole numbers of at least 1, with a product of at most 100000000";
  if (!this->Json->is_array() || this->Json->size() != 2)
  {
    this->failExpected(expected);
  }
  std::array<int, 2> resolution{};
  double product = 1.0;
  for (int i = 0; i < 2; ++i)
  {
    const json& value = (*this->Json)[i];
    const double number = value.is_number() ? value.get<double>() : 0.0;
    product *= number;
    if (number != std::floor(number) || number < 1.0 || product > maximum)
    {
      this->failExpected(expected);
    }
    resolution[i] = static_cast<int>(number);
  }
  return resolution;
}

std::vector<double> JsonCursor::bands(double below) const
{
  const std::string range = std::isfinite(below) ? "at least 0 and below " + text(below) : "at least 0";
  const std::string expected =
      "a number of " + range + ", or 1 to " + std::to_string(MaximumBands) + " such numbers, one a band";
  std::vector<double> bands;
  if (this->Json->is_number())
  {
    bands.push_back(this->Json->get<double>());
  }
  else if (this->Json->is_array() && !this->Json->empty() && this->Json->size() <= MaximumBands)
  {
    for (const json& value : *this->Json)
    {
      bands.push_back(value.is_number() ? value.get<double>() : -1.0);
    }
  }
  if (bands.empty() || !std::all_of(bands.begin(), bands.end(), [=](double b) { return b >= 0.0 && b < below; }))
  {
    this->failExpected(expected);
  }
  return bands;
}

std::vector<JsonCursor> JsonCursor::items() const
{
  if (!this->Json->is_array())
  {
    this->failExpected("an array");
  }
  std::vector<JsonCursor> items;
  for (std::size_t i = 0; i < this->Json->size(); ++i)
  {
    const json& item = (*this->Json)[i];
    const bool named = item.is_object() && item.contains("name") && item["name"].is_string();
    items.emplace_back(item,
                       this->Place + (named ? "." + item["name"].get<std::string>() : "[" + std::to_string(i) + "]"));
  }
  return items;
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const
{
  if (!this->Json->is_object())
  {
    this->failExpected("an object");
  }
  std::vector<std::pair<std::string, JsonCursor>> members;
  for (const auto& member : this->Json->items())
  {
    members.emplace_back(member.key(), JsonCursor(member.value(), this->Place + "." + member.key()));
  }
  return members;
}

std::string JsonCursor::name() const
{
  const JsonCursor node = this->at("name");
  const std::string name = node.string();
  const bool plain =
      std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == '/' || c == '\\'; });
  // Results are files called NAME.csv and the like.
  if (name.empty() || name.size() > 200 || name.front() == '.' || !plain)
  {
    node.failExpected("a name that can be a file name: 1 to 200 characters, no slash, no dot at the start");
  }
  return name;
}
}  // namespace kalos::scene
