// SPDX-License-Identifier: BSD-3-Clause
/** Decodes the URIs of a glTF. */
#ifndef KalosUriText_h
#define KalosUriText_h

#include <string>

#include "../base/JsonCursor.h"

namespace kalos::scene
{
/** The content of `data:TYPE;base64,TEXT`, whose TEXT begins there; `uri` is for messages. */
std::string decodeBase64(const JsonCursor& uri, const std::string& text, std::size_t begin);

/** Replaces %20 and the like by their characters. */
std::string decodePercent(const std::string& text);
}  // namespace kalos::scene

#endif
