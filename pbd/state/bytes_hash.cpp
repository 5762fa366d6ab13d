// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A hash of bytes, for files.
#include "pbd/state/bytes_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meniscus::pbd {

uint64_t bytes_hash(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace meniscus::pbd
