// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks glTF files before assimp reads them.
#include "collision/mesh/file/gltf.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

using Json = nlohmann::json;

constexpr size_t header_size = 12, chunk_header_size = 8;

uint32_t number_at(std::string_view bytes, size_t at) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// The JSON of a binary file, after all its chunks were found to lie within the file.
std::string_view json_of_binary(std::string_view bytes) {
  if (bytes.size() < header_size + chunk_header_size) throw FileDefect("ends within its header");
  if (number_at(bytes, 4) != 2)
    throw FileDefect("is glTF of version " + std::to_string(number_at(bytes, 4)) + "; version 2 is read");
  if (number_at(bytes, 8) != bytes.size()) {
    throw FileDefect("promises " + std::to_string(number_at(bytes, 8)) + " bytes, and has " +
                     std::to_string(bytes.size()));
  }
  for (size_t at = header_size; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    if (left < chunk_header_size || number_at(bytes, at) > left - chunk_header_size)
      throw FileDefect("ends within its chunk at byte " + std::to_string(at));
    at += chunk_header_size + number_at(bytes, at);
  }
  if (bytes.substr(header_size + 4, 4) != "JSON") throw FileDefect("does not begin with a chunk of JSON");
  return bytes.substr(header_size + chunk_header_size, number_at(bytes, header_size));
}

Json parsed(std::string_view text) {
  const auto bound_depth = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > mesh_file_tuning::most_levels) {
      throw FileDefect("is nested more than " + std::to_string(mesh_file_tuning::most_levels) +
                       " levels deep");
    }
    return true;
  };
  Json document = Json::parse(text, bound_depth, false);
  if (!document.is_object()) throw FileDefect("is not valid JSON, or not a JSON object");
  return document;
}

/// Without a view of a buffer, nothing in the file holds what an accessor counts.
void check_accessors(const Json& document, size_t file_size) {
  const auto accessors = document.find("accessors");
  if (accessors == document.end()) return;
  size_t number = 0;
  for (const Json& accessor : *accessors) {
    const std::string name = "has accessor " + std::to_string(number++);
    if (!accessor.is_object()) throw FileDefect(name + " that is no object");
    const auto count = accessor.find("count");
    if (count == accessor.end() || !count->is_number_unsigned()) throw FileDefect(name + " without a count");
    if (accessor.contains("bufferView") && !accessor.contains("sparse")) continue;
    if (count->get<uint64_t>() > file_size)
      throw FileDefect(name + " of " + count->dump() + " elements, for which the file is too short");
  }
}

}  // namespace

void check_gltf(std::string_view bytes) {
  const std::string_view json = bytes.starts_with("glTF") ? json_of_binary(bytes) : bytes;
  check_accessors(parsed(json), bytes.size());
}

}  // namespace meniscus::collision
