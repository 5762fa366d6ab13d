// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds a JSON document from what the library's parser meets.
#include "sdk/scene/scene_document.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

/// "line 3, column 5" of the last byte that the parser took, which the library counts from 1.
std::string position_of(std::size_t byte, const std::string& text) {
  const std::size_t end = std::min(byte, text.size());
  const std::size_t last = end > 0 ? end - 1 : 0;
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(last), '\n');
  const std::size_t line_break = last > 0 ? text.rfind('\n', last - 1) : std::string::npos;
  const std::size_t column = line_break == std::string::npos ? last + 1 : last - line_break;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// What comes after the library's own headings: "[json.exception.…] parse error at …: what is wrong".
std::string plain_message(const Json::exception& error) {
  const bool is_syntax =
      dynamic_cast<const Json::parse_error*>(&error);  // else a number that no double holds
  const std::string heading_end = is_syntax ? ": " : "] ", message = error.what();
  const std::size_t end = message.find(heading_end);
  return end == std::string::npos ? message : message.substr(end + heading_end.size());
}

class DocumentBuilder final : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(Json& root, const std::string& text, const std::string& source)
      : root_(root), text_(text), place_{source, ""} {}

  bool null() override { return put(nullptr), true; }
  bool boolean(bool value) override { return put(value), true; }
  bool number_integer(number_integer_t value) override { return put(value), true; }
  bool number_unsigned(number_unsigned_t value) override { return put(value), true; }
  bool number_float(number_float_t value, const string_t&) override { return put(value), true; }
  bool string(string_t& value) override { return put(with_no_nul(value)), true; }
  bool binary(binary_t&) override { return false; }  // JSON has none
  bool start_object(std::size_t) override { return begin(Json::object()); }
  bool start_array(std::size_t) override { return begin(Json::array()); }
  bool end_object() override { return open_.pop_back(), true; }
  bool end_array() override { return open_.pop_back(), true; }

  bool key(string_t& value) override {
    if (open_.back()->contains(with_no_nul(value)))
      place_.fail("the key " + Json(value).dump() + " stands twice in one object");
    key_ = std::move(value);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const Json::exception& error) override {
    place_.fail(position_of(byte, text_) + ": " + plain_message(error));
  }

 private:
  Json& put(Json value) {
    if (open_.size() > most_levels)
      place_.fail("is nested more than " + std::to_string(most_levels) + " levels deep");
    if (open_.empty()) return root_ = std::move(value);
    Json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return parent.back();
    }
    return parent.emplace(std::move(key_), std::move(value)).first.value();
  }

  bool begin(Json empty) {
    Json& value = put(std::move(empty));
    open_.push_back(&value);
    return true;
  }

  string_t& with_no_nul(string_t& value) const {
    if (value.find('\0') != std::string::npos)
      place_.fail("the text " + Json(value).dump() + " has a NUL character");
    return value;
  }

  Json& root_;
  const std::string& text_;
  const ScenePlace place_;
  std::vector<Json*> open_;  ///< the arrays and objects around
  string_t key_;
};

}  // namespace

void take_apart(Json& document) noexcept {
  if (!document.is_structured()) return;
  for (Json& child : document) take_apart(child);
  document.clear();
}

SceneDocument parse_document(const std::string& text, const std::string& source) {
  constexpr bool to_the_end = true, comments_allowed = true;
  SceneDocument document;
  DocumentBuilder builder(document.value, text, source);
  Json::sax_parse(text, &builder, Json::input_format_t::json, to_the_end, comments_allowed);
  return document;
}

}  // namespace meniscus
