// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Elements of several numbers, aligned to 8 or 16 bytes, in a group's scratch memory. Access number by number
// would cause bank conflicts in a GPU's shared memory between adjacent elements.
#pragma once

#include <cstdint>
#include <type_traits>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

#ifdef __CUDA_ARCH__
template <class T>
using WordOf = std::conditional_t<alignof(T) == sizeof(uint4), uint4, uint2>;
#endif

template <class T>
MENISCUS_HD T read_whole(const T* from, uint32_t i) {
#ifdef __CUDA_ARCH__
  constexpr uint32_t count = sizeof(T) / sizeof(WordOf<T>);
  WordOf<T> words[count];
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < count; ++k) words[k] = reinterpret_cast<const WordOf<T>*>(from + i)[k];
  T value;
  __builtin_memcpy(&value, words, sizeof value);
  return value;
#else
  return from[i];
#endif
}

template <class T>
MENISCUS_HD void write_whole(T* to, uint32_t i, const std::type_identity_t<T>& value) {
#ifdef __CUDA_ARCH__
  constexpr uint32_t count = sizeof(T) / sizeof(WordOf<T>);
  WordOf<T> words[count];
  __builtin_memcpy(words, &value, sizeof value);
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < count; ++k) reinterpret_cast<WordOf<T>*>(to + i)[k] = words[k];
#else
  to[i] = value;
#endif
}

}  // namespace meniscus::pbd
