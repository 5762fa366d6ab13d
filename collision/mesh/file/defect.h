// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a reader of mesh files throws, and the cursor that readers share.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meniscus::collision {

/// The defect of a file, as the end of a sentence that begins with the file: "ends within its header".
class FileDefect : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A text that is read word by word. It never reads beyond its end.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word. Empty at the end of the text.
  std::string_view next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const std::string_view word = rest_.substr(0, std::min(rest_.find_first_of(blanks), rest_.size()));
    rest_.remove_prefix(word.size());
    return word;
  }
  /// The rest of the line, without its end, which is passed over.
  std::string_view line() {
    const size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }
  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

 private:
  static constexpr std::string_view blanks = " \t\r\n\v\f";

  std::string_view rest_;
};

/// The number that a whole word is; none if it is not one, or out of the type's range.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

/// The start of a word, in quotes, for a message.
inline std::string in_quotes(std::string_view word) {
  std::string text = "'";
  text.append(word.substr(0, 40)).push_back('\'');
  return text;
}

}  // namespace meniscus::collision
