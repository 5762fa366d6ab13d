// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts an OpenUSD file in text form into words, numbers, texts and marks.
#pragma once

#include <cstddef>
#include <string_view>

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

/// The tokens of a text, one after another. They refer to it. A step throws FileDefect for a text in quotes
/// without an end, and for a character that no token begins with.
class UsdaTokens {
 public:
  explicit UsdaTokens(std::string_view text) : text_(text) { step(); }

  /// The next one; at the end of the text, one of the kind `end`.
  const UsdaToken& next() const { return next_; }
  /// Takes it, and steps to the one after it.
  UsdaToken take();

 private:
  void step();
  bool skip_space();
  void cut();
  void set(UsdaToken::Kind kind, size_t length);
  void cut_number();
  void cut_text(char quote);
  void cut_until(std::string_view mark, size_t opening);

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
  UsdaToken next_{};
};

}  // namespace meniscus::motion
