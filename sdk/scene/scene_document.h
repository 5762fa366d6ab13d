// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contents of a scene file as a JSON document.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus {

/// Arrays and objects inside one another, at most: recursion over documents must not overrun the stack.
inline constexpr std::size_t most_levels = 256;

/// Empties a document from its innermost values on. The library's destructor takes memory for what is not
/// empty, and ends the program where there is none.
void take_apart(nlohmann::json& document) noexcept;

/// A document that needs no memory to be destroyed.
struct SceneDocument {
  nlohmann::json value;

  SceneDocument() = default;
  SceneDocument(SceneDocument&&) = default;
  SceneDocument& operator=(SceneDocument&&) = delete;
  ~SceneDocument() { take_apart(value); }
};

/// Parses a text. Refuses an object in which a key stands twice; the library would keep the last and say
/// nothing. Refuses a text with a NUL, which would end messages that name it, and nesting that overruns the
/// stack. `source` begins the message of each Error(parse).
SceneDocument parse_document(const std::string& text, const std::string& source);

}  // namespace meniscus
