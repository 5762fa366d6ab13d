// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts an OpenUSD file in text form into tokens.
#include "sdk/motion/usda_tokens.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "collision/mesh/file/defect.h"

namespace meniscus::motion {

namespace {

using collision::FileDefect;
using Kind = UsdaToken::Kind;

bool begins_word(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool is_in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':' || c == '.';
}
bool is_in_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) ||
         std::string_view("+-.eE").find(c) != std::string_view::npos;
}

template <class Is>
size_t length_of(std::string_view text, const Is& is) {
  return static_cast<size_t>(std::ranges::find_if_not(text, is) - text.begin());
}

}  // namespace

UsdaToken UsdaTokens::take() {
  const UsdaToken token = next_;
  step();
  return token;
}

void UsdaTokens::step() {
  if (skip_space())
    cut();
  else
    next_ = {Kind::end, {}, 0, line_};
}

bool UsdaTokens::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    else if (!std::isspace(static_cast<unsigned char>(text_[at_])))
      return true;
    if (at_ >= text_.size()) return false;
    if (text_[at_] == '\n') ++line_;
  }
  return false;
}

void UsdaTokens::cut() {
  const char c = text_[at_];
  if (begins_word(c)) return set(Kind::word, length_of(text_.substr(at_), is_in_word));
  if (std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '+' || c == '.') return cut_number();
  if (c == '"' || c == '\'') return cut_text(c);
  if (c == '@') return cut_until("@", 1);
  if (c == '<') return cut_until(">", 1);
  if (std::string_view("(){}[]=,;:").find(c) != std::string_view::npos) return set(Kind::mark, 1);
  throw FileDefect("has an unknown character in line " + std::to_string(line_) + ": " +
                   collision::in_quotes(text_.substr(at_, 1)));
}

void UsdaTokens::set(Kind kind, size_t length) {
  next_ = {kind, text_.substr(at_, length), 0, line_};
  at_ += length;
}

void UsdaTokens::cut_number() {
  const std::string_view word = text_.substr(at_, length_of(text_.substr(at_), is_in_number));
  const auto number = collision::number_of<double>(word);
  if (!number && text_.substr(at_ + 1, 3) == "inf") return set(Kind::word, 4);  // -inf
  if (!number)
    throw FileDefect("has no number in line " + std::to_string(line_) + ": " + collision::in_quotes(word));
  set(Kind::number, word.size());
  next_.number = *number;
}

/// In three quotes a text may have several lines.
void UsdaTokens::cut_text(char quote) {
  const std::string three(3, quote);
  const bool is_long = text_.substr(at_, 3) == three;
  cut_until(is_long ? three : std::string(1, quote), is_long ? 3 : 1);
}

void UsdaTokens::cut_until(std::string_view mark, size_t opening) {
  const size_t begin = at_ + opening;
  size_t end = begin;
  while (end < text_.size() && text_.substr(end, mark.size()) != mark) end += text_[end] == '\\' ? 2 : 1;
  if (end >= text_.size())
    throw FileDefect("has a text without an end from line " + std::to_string(line_) + " on");
  next_ = {Kind::text, text_.substr(begin, end - begin), 0, line_};
  line_ += static_cast<int>(std::ranges::count(next_.text, '\n'));
  at_ = end + mark.size();
}

}  // namespace meniscus::motion
