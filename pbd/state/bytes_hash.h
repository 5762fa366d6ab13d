// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A hash of bytes, for files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace meniscus::pbd {

/// XXH3 of 64 bits.
uint64_t bytes_hash(std::span<const std::byte> bytes);

}  // namespace meniscus::pbd
