// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "InputError.h"
#include "JsonCursor.h"

namespace kalos::scene
{
namespace
{
using nlohmann::json;

/** Watches the parser for what JSON allows and a scene does not: duplicate keys and bottomless nesting. */
class Watch
{
public:
  bool operator()(int depth, json::parse_event_t event, json& parsed)
  {
    if (depth > MaximumDepth)
    {
      throw InputError(this->path(),
                       "nested deeper than " + std::to_string(MaximumDepth) + " levels; expected a scene");
    }
    if (event == json::parse_event_t::object_start)
    {
      this->Frames.emplace_back();
    }
    else if (event == json::parse_event_t::object_end && !this->Frames.empty())
    {
      this->Frames.pop_back();
    }
    else if (event == json::parse_event_t::key && !this->Frames.empty())
    {
      Frame& frame = this->Frames.back();
      frame.key = parsed.get<std::string>();
      if (!frame.keys.insert(frame.key).second)
      {
        throw InputError(this->path(), "this key appears twice; expected once");
      }
    }
    return true;
  }

private:
  struct Frame
  {
    std::string key;
    std::set<std::string> keys;
  };

  std::string path() const
  {
    std::string path;
    for (const Frame& frame : this->Frames)
    {
      path += (path.empty() || frame.key.empty() ? "" : ".") + frame.key;
    }
    return path.empty() ? "scene" : path;
  }

  std::vector<Frame> Frames;
};

std::string lineAndColumn(const std::string& text, std::size_t byte)
{
  const std::size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t newline = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t column = newline == std::string::npos ? end + 1 : end - newline;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}
}  // namespace

json parseJson(const std::string& text)
{
  try
  {
    Watch watch;
    return json::parse(
        text, [&watch](int depth, json::parse_event_t event, json& parsed) { return watch(depth, event, parsed); });
  }
  catch (const json::parse_error& error)
  {
    // The library's text is "[...] parse error at line 1, column 2: reason"; keep the reason.
    std::string reason = error.what();
    const std::size_t place = reason.find("column ");
    const std::size_t colon = reason.find(": ", place == std::string::npos ? 0 : place);
    reason = colon == std::string::npos ? reason : reason.substr(colon + 2);
    std::replace_if(
        reason.begin(), reason.end(), [](unsigned char c) { return c > 126; }, '?');
    throw InputError(lineAndColumn(text, error.byte), "malformed JSON: " + reason);
  }
  catch (const json::out_of_range& error)
  {
    const std::string reason = error.what();
    throw InputError("scene",
                     "a number is too large: " + reason.substr(reason.find("] ") + 2) + "; expected a finite one");
  }
}
}  // namespace kalos::scene
