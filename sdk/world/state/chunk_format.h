// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The first bytes of a snapshot file (chunk_file.h), and its versions.
#pragma once

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meniscus::chunk_format {

using Json = nlohmann::ordered_json;

inline constexpr char magic[8] = {'M', 'E', 'N', 'I', 'S', 'N', 'A', 'P'};
inline constexpr uint32_t format_version = 1;
inline constexpr uint32_t chunk_version = 1;
static_assert(std::endian::native == std::endian::little);

struct Prefix {
  char magic[8];
  uint32_t version, header_bytes;
  uint64_t header_hash;
};
static_assert(sizeof(Prefix) == 24);

}  // namespace meniscus::chunk_format
