// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What all keyframes have in common: their times.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace meniscus {

/// Strictly: a thing cannot be at two places at once.
template <class K>
bool in_order(const std::vector<K>& keyframes) {
  const auto not_later = [](const K& a, const K& b) { return a.time >= b.time; };
  return std::adjacent_find(keyframes.begin(), keyframes.end(), not_later) == keyframes.end();
}

template <class V, class K>
void check_keyframes(V& v, const std::vector<K>& keyframes, bool loop) {
  v.check(in_order(keyframes), "the times of keyframes must increase", "keyframes", keyframes);
  v.check(!loop || keyframes.size() >= 2, "loop needs at least 2 keyframes", "keyframes", keyframes);
}

}  // namespace meniscus
