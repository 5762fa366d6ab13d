// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts an OpenUSD file in text form into words, numbers, texts and marks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meniscus::motion {

struct UsdaToken {
  enum class Kind { word, number, text, mark, end };
  Kind kind = Kind::end;
  std::string_view text{};  ///< of a text without its quotes
  double number = 0;
  int line = 0;

  bool is(char mark) const { return kind == Kind::mark && text.front() == mark; }
  bool is_word(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// Ends with a token of the kind `end`. The tokens refer to `text`. Throws FileDefect for a text without an
/// end, and for a character that no token begins with.
std::vector<UsdaToken> usda_tokens(std::string_view text);

}  // namespace meniscus::motion
