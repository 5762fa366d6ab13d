// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Values of one world, repeated for all worlds of a batch (worlds.h).
#pragma once

#include <span>
#include <vector>

#include "pbd/device/buffer.h"

namespace meniscus::pbd {

/// The values `times` times, one after the other. `change(value, k)` adapts those of repetition k.
template <class T, class Change>
std::vector<T> repeated(std::span<const T> values, uint32_t times, const Change& change) {
  std::vector<T> all;
  all.reserve(times * values.size());
  for (uint32_t k = 0; k < times; ++k) {
    for (T value : values) {
      change(value, k);
      all.push_back(value);
    }
  }
  return all;
}

template <class T>
std::vector<T> repeated(std::span<const T> values, uint32_t times) {
  return repeated(values, times, [](T&, uint32_t) {});
}

template <class T>
void write_repeated(Buffer<T>& buffer, std::span<const T> values, uint32_t times) {
  const std::vector<T> all = repeated(values, times);
  buffer.resize_discard(all.size());
  buffer.write(all);
}

}  // namespace meniscus::pbd
