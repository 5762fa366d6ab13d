// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The header of a PLY file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::collision {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count = PlyType::uint8;  ///< of a list
  PlyType type = PlyType::float32;
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::string_view body;  ///< all bytes after the header
};

/// Throws FileDefect, also if the elements cannot have room in the body.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace meniscus::collision
