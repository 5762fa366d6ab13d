// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The form of calls in recordings, before the JSON library reads them: it recurses into what is nested.
#pragma once

#include <cstdint>
#include <span>

namespace meniscus::call_text {

/// The deepest nesting of lists and objects in a call. Definitions have less than 10.
inline constexpr std::size_t max_depth = 32;

/// Throws Error(io) unless the bytes are one CBOR item (RFC 8949, section 3) that ends with them, of definite
/// lengths, without tags, and nested at most max_depth deep.
void check_cbor(std::span<const uint8_t> bytes);

}  // namespace meniscus::call_text
