// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A view of an array in a device's memory, with prefetching and read-only loads.
#pragma once

#include <cassert>
#include <cstdint>
#include <type_traits>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// A non-owning view of an array in a device's memory. Kernels take views by value.
template <class T>
struct View {
  T* data = nullptr;
  uint32_t count = 0;

  MENISCUS_HD T& operator[](uint32_t i) const {
#ifndef __CUDA_ARCH__
    assert(i < count);
#endif
    return data[i];
  }

  MENISCUS_HD View first(uint32_t n) const {
    return {data, n};
  }
  MENISCUS_HD View from(uint32_t n) const {
    return {data + n, count - n};
  }

  /// A writable view converts to a read-only one.
  template <class U>
  requires(std::is_same_v<U, const T> && !std::is_const_v<T>) MENISCUS_HD operator View<U>() const {
    return {data, count};
  }
};

/// Prefetches element i, which is read soon.
template <class T>
MENISCUS_HD void prefetch(View<T> from, uint32_t i) {
#ifdef __CUDA_ARCH__
  asm volatile("prefetch.global.L1 [%0];" ::"l"(from.data + i));
#else
  __builtin_prefetch(from.data + i);
#endif
}

/// Element i of an array that no thread writes while the kernel runs. This lets the compiler keep several
/// loads in flight across a store that might alias.
template <class T>
MENISCUS_HD T load(View<const T> from, uint32_t i) {
#ifdef __CUDA_ARCH__
  if constexpr (sizeof(T) == 16) {
    const uint4 words = __ldg(reinterpret_cast<const uint4*>(from.data + i));
    T value;
    __builtin_memcpy(&value, &words, sizeof value);
    return value;
  } else if constexpr (sizeof(T) == 8) {
    const uint2 words = __ldg(reinterpret_cast<const uint2*>(from.data + i));
    T value;
    __builtin_memcpy(&value, &words, sizeof value);
    return value;
  } else {
    return __ldg(from.data + i);
  }
#else
  return from[i];
#endif
}

}  // namespace meniscus::pbd
