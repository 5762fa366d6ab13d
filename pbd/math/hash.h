// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Hashes of a state that do not depend on the order of its elements: the sum, modulo 2^64, of a hash of each
// element's number and bits. Integer sums are associative, so a device may add them in any order.
#pragma once

#include <cstdint>
#include <cstring>

#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// A bijection in which each bit of x reaches all others (splitmix64; Steele, Lea & Flood 2014).
MENISCUS_HD inline uint64_t mixed(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

MENISCUS_HD inline uint64_t mixed_with(uint64_t hash, float a, float b) {
  uint32_t bits[2];
  std::memcpy(bits, &a, sizeof a);
  std::memcpy(bits + 1, &b, sizeof b);
  return mixed(hash ^ (uint64_t{bits[1]} << 32 | bits[0]));
}

/// The hash of the bits of two vectors, for an element with a unique `number`.
MENISCUS_HD inline uint64_t element_hash(uint64_t number, Vec3 a, Vec3 b) {
  uint64_t hash = mixed(number);
  hash = mixed_with(hash, a.x, a.y);
  hash = mixed_with(hash, a.z, b.x);
  return mixed_with(hash, b.y, b.z);
}

}  // namespace meniscus::pbd
