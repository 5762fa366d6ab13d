// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The first bytes of a snapshot file (chunk_file.h), and its versions.
#pragma once

#include <meniscus/error.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meniscus::chunk_format {

using Json = nlohmann::ordered_json;

inline constexpr char magic[8] = {'M', 'E', 'N', 'I', 'S', 'N', 'A', 'P'};
inline constexpr uint32_t format_version = 1;
/// Of a chunk in one part, and of one in several.
inline constexpr uint32_t chunk_version = 1, parted_version = 2;
static_assert(std::endian::native == std::endian::little);

struct Prefix {
  char magic[8];
  uint32_t version, header_bytes;
  uint64_t header_hash;
};
static_assert(sizeof(Prefix) == 24);

/// The length of a header as the prefix has it. Throws Error(capacity) if it has no room there.
inline uint32_t header_length(std::size_t bytes) {
  if (bytes <= std::numeric_limits<uint32_t>::max()) return static_cast<uint32_t>(bytes);
  throw Error(ErrorCode::capacity, "the definitions of the world take " + std::to_string(bytes) +
                                       " bytes in a file; there is room for at most 4294967295");
}

}  // namespace meniscus::chunk_format
