// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads PLY files, binary and ASCII.
#include "collision/mesh/file/ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/ply_header.h"

namespace meniscus::collision {

namespace {

/// The values of a body in their order.
class Values {
 public:
  explicit Values(const PlyHeader& header)
      : format_(header.format), words_(header.body), left_(header.body) {}

  double next(PlyType type, const std::string& element) {
    return format_ == PlyFormat::ascii ? next_word(element) : next_bytes(type, element);
  }
  /// Of the bytes that are left, those that `count` values of this type need at least, are there.
  bool has_room(uint64_t count, PlyType type) const {
    const bool ascii = format_ == PlyFormat::ascii;
    return count <= (ascii ? words_.rest().size() / 2 + 1 : left_.size() / size_of(type));
  }

 private:
  double next_word(const std::string& element) {
    const std::string_view word = words_.next();
    if (word.empty()) throw FileDefect("ends within its element " + in_quotes(element));
    const auto value = number_of<double>(word);
    if (!value)
      throw FileDefect("has " + in_quotes(word) + " in place of a number in its element " +
                       in_quotes(element));
    return *value;
  }

  double next_bytes(PlyType type, const std::string& element) {
    const size_t size = size_of(type);
    if (left_.size() < size) throw FileDefect("ends within its element " + in_quotes(element));
    char bytes[8];
    std::memcpy(bytes, left_.data(), size);
    left_.remove_prefix(size);
    const bool is_little = std::endian::native == std::endian::little;
    if (is_little != (format_ == PlyFormat::little_endian)) std::reverse(bytes, bytes + size);
    switch (type) {
      case PlyType::int8:
        return as<int8_t>(bytes);
      case PlyType::uint8:
        return as<uint8_t>(bytes);
      case PlyType::int16:
        return as<int16_t>(bytes);
      case PlyType::uint16:
        return as<uint16_t>(bytes);
      case PlyType::int32:
        return as<int32_t>(bytes);
      case PlyType::uint32:
        return as<uint32_t>(bytes);
      case PlyType::float32:
        return as<float>(bytes);
      case PlyType::float64:
        return as<double>(bytes);
    }
    return 0;
  }

  template <class T>
  static double as(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  }

  PlyFormat format_;
  Words words_;
  std::string_view left_;
};

bool is_integer(double value) {
  return value == std::floor(value);
}

class BodyReader {
 public:
  explicit BodyReader(const PlyHeader& header) : header_(header), values_(header) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") vertices_ += element.count;
    }
  }

  Polygons read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (uint64_t i = 0; i < element.count; ++i) read_one(element, i);
    }
    return std::move(all_);
  }

 private:
  void read_one(const PlyElement& element, uint64_t number) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Vec3 vertex{0, 0, 0};
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) {
        const bool is_corners =
            is_face && (property.name == "vertex_indices" || property.name == "vertex_index");
        read_list(element, property, number, is_corners);
        continue;
      }
      const auto value = static_cast<float>(values_.next(property.type, element.name));
      if (property.name == "x") vertex.x = value;
      if (property.name == "y") vertex.y = value;
      if (property.name == "z") vertex.z = value;
    }
    if (is_vertex) all_.vertices.push_back(vertex);
  }

  void read_list(const PlyElement& element, const PlyProperty& property, uint64_t number, bool is_corners) {
    const double length = values_.next(property.count, element.name);
    if (!(length >= 0) || !is_integer(length) || length > 4e9 ||
        !values_.has_room(static_cast<uint64_t>(length), property.type)) {
      throw FileDefect("is too short for a list of its element " + in_quotes(element.name) + " number " +
                       std::to_string(number));
    }
    const size_t first = all_.corners.size();
    for (uint64_t i = 0; i < static_cast<uint64_t>(length); ++i) {
      const double value = values_.next(property.type, element.name);
      if (!is_corners) continue;
      if (!(value >= 0) || !is_integer(value) || value >= static_cast<double>(vertices_)) {
        throw FileDefect("has a face with a vertex that it lacks: face " + std::to_string(number) + " of " +
                         std::to_string(vertices_) + " vertices");
      }
      all_.corners.push_back(static_cast<uint32_t>(value));
    }
    if (!is_corners) return;
    if (length < 3)
      all_.corners.resize(first);  // a point or a line
    else
      all_.ends.push_back(static_cast<uint32_t>(all_.corners.size()));
  }

  const PlyHeader& header_;
  Values values_;
  uint64_t vertices_ = 0;
  Polygons all_;
};

}  // namespace

Polygons read_ply(std::string_view bytes) {
  const PlyHeader header = read_ply_header(bytes);
  return BodyReader(header).read();
}

}  // namespace meniscus::collision
