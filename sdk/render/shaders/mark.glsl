// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// One thing more that a distance can say, in its last bit.
bool is_marked(float distance) {
  return (floatBitsToUint(distance) & 1u) != 0u;
}
float marked(float distance, bool is) {
  return uintBitsToFloat((floatBitsToUint(distance) & ~1u) | uint(is));
}
