// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The header of a PLY file.
#include "collision/mesh/file/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "collision/mesh/file/defect.h"

namespace meniscus::collision {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

PlyType type_of(std::string_view word) {
  for (const auto& [name, type] : types) {
    if (name == word) return type;
  }
  throw FileDefect("has a property of the unknown type " + in_quotes(word));
}

PlyFormat format_of(std::string_view word) {
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::little_endian;
  if (word == "binary_big_endian") return PlyFormat::big_endian;
  throw FileDefect("has the unknown format " + in_quotes(word));
}

PlyElement element_of(Words& words) {
  PlyElement element;
  element.name = words.next();
  const std::string_view count = words.next();
  const auto value = number_of<uint64_t>(count);
  if (!value) throw FileDefect("has " + in_quotes(count) + " in place of the number of an element");
  element.count = *value;
  return element;
}

PlyProperty property_of(Words& words) {
  PlyProperty property;
  std::string_view type = words.next();
  if (type == "list") {
    property.is_list = true;
    property.count = type_of(words.next());
    if (property.count == PlyType::float32 || property.count == PlyType::float64)
      throw FileDefect("has a list whose length is no integer");
    type = words.next();
  }
  property.type = type_of(type);
  property.name = words.next();
  return property;
}

/// The bytes that an element takes at least. In ASCII a value takes one digit and one blank.
uint64_t least_size(const PlyElement& element, PlyFormat format) {
  uint64_t bytes = 0;
  for (const PlyProperty& p : element.properties)
    bytes += format == PlyFormat::ascii ? 2 : size_of(p.is_list ? p.count : p.type);
  return bytes;
}

void check_room(const PlyHeader& header) {
  uint64_t left = header.body.size() + 1;  // the last blank may be missing
  for (const PlyElement& element : header.elements) {
    const uint64_t least = least_size(element, header.format);
    if (least > 0 && element.count > left / least) {
      throw FileDefect("promises " + std::to_string(element.count) + " of its element " +
                       in_quotes(element.name) + ", for which it is too short");
    }
    left -= least * element.count;
  }
}

}  // namespace

size_t size_of(PlyType type) {
  constexpr std::array<size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes) {
  PlyHeader header;
  Words lines(bytes);
  if (lines.line() != "ply") throw FileDefect("does not begin with 'ply'");
  bool has_format = false;
  for (;;) {
    if (lines.at_end()) throw FileDefect("ends within its header, before 'end_header'");
    Words words(lines.line());
    const std::string_view key = words.next();
    if (key == "end_header") break;
    if (key == "format") {
      header.format = format_of(words.next());
      has_format = true;
    } else if (key == "element") {
      header.elements.push_back(element_of(words));
    } else if (key == "property") {
      if (header.elements.empty()) throw FileDefect("has a property before its first element");
      header.elements.back().properties.push_back(property_of(words));
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      throw FileDefect("has the unknown line " + in_quotes(key) + " in its header");
    }
  }
  if (!has_format) throw FileDefect("has no format in its header");
  header.body = lines.rest();
  check_room(header);
  return header;
}

}  // namespace meniscus::collision
