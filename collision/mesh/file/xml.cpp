// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Walks through the tags of an XML file.
#include "collision/mesh/file/xml.h"

#include <algorithm>
#include <array>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text;
}

}  // namespace

std::optional<XmlTag> XmlTags::next() {
  do {
    const size_t start = rest_.find('<');
    if (start == std::string_view::npos) {
      if (!open_.empty()) throw FileDefect("ends within its element " + in_quotes(open_.back()));
      return {};
    }
    rest_.remove_prefix(start);
  } while (skip_special());
  // A bracket within the quotes of an attribute does not end the tag.
  char quote = 0;
  size_t end = 1;
  for (; end < rest_.size() && (quote || rest_[end] != '>'); ++end) {
    if (quote ? rest_[end] == quote : (rest_[end] == '"' || rest_[end] == '\''))
      quote = quote ? 0 : rest_[end];
  }
  if (end == rest_.size()) throw FileDefect("ends within a tag");
  XmlTag found = tag(rest_.substr(1, end - 1));
  rest_.remove_prefix(end + 1);
  found.text = rest_.substr(0, std::min(rest_.find('<'), rest_.size()));
  nest(found);
  return found;
}

bool XmlTags::skip_special() {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> specials{
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}}};
  for (const auto& [start, end] : specials) {
    if (!rest_.starts_with(start)) continue;
    const size_t at = rest_.find(end, start.size());
    if (at == std::string_view::npos) throw FileDefect("ends within " + in_quotes(start));
    rest_.remove_prefix(at + end.size());
    return true;
  }
  return false;
}

XmlTag XmlTags::tag(std::string_view inside) {
  XmlTag found;
  if (inside.starts_with('/')) {
    found.opens = false;
    found.closes = true;
    inside.remove_prefix(1);
  } else if (inside.ends_with('/')) {
    found.closes = true;
    inside.remove_suffix(1);
  }
  found.name = inside.substr(0, std::min(inside.find_first_of(blanks), inside.size()));
  if (found.name.empty()) throw FileDefect("has a tag without a name");
  read_attributes(found, inside.substr(found.name.size()));
  return found;
}

void XmlTags::read_attributes(XmlTag& tag, std::string_view inside) const {
  for (inside = trimmed(inside); !inside.empty(); inside = trimmed(inside)) {
    const size_t equals = inside.find('=');
    const size_t quote = equals == std::string_view::npos ? equals : inside.find_first_of("\"'", equals);
    const size_t end = quote == std::string_view::npos ? quote : inside.find(inside[quote], quote + 1);
    if (end == std::string_view::npos)
      throw FileDefect("has an attribute without a value in its tag " + in_quotes(tag.name));
    std::string_view key = inside.substr(0, equals);
    key = key.substr(0, std::min(key.find_first_of(blanks), key.size()));
    tag.attributes[key] = inside.substr(quote + 1, end - quote - 1);
    inside.remove_prefix(end + 1);
  }
}

void XmlTags::nest(const XmlTag& tag) {
  if (tag.opens) open_.push_back(tag.name);
  if (static_cast<int>(open_.size()) > mesh_file_tuning::most_levels)
    throw FileDefect("is nested more than " + std::to_string(mesh_file_tuning::most_levels) + " levels deep");
  if (!tag.closes) return;
  if (open_.empty() || open_.back() != tag.name)
    throw FileDefect("closes " + in_quotes(tag.name) + ", which is not open");
  open_.pop_back();
}

}  // namespace meniscus::collision
