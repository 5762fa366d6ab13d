// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Padding bytes of a value, cleared so that equal values are equal byte by byte.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <cstring>

namespace meniscus::pbd {

#if __has_builtin(__builtin_clear_padding) && CUDART_VERSION >= 12040

/// GCC 12 looks in the wrong place for the padding after an array of structs of more than 64 bytes, and
/// clears meaningful bytes there. Such a T is detected by padding whose position is known: after a byte that
/// follows it.
template <class T>
bool knows_padding() {
  struct Followed {
    T value;
    unsigned char byte;
    alignas(16) unsigned char next[16];
  };
  alignas(Followed) unsigned char memory[sizeof(Followed)];
  std::memset(memory, 0xff, sizeof memory);
  auto* const followed = reinterpret_cast<Followed*>(memory);
  __builtin_clear_padding(followed);
  for (const unsigned char* at = &followed->byte + 1; at != followed->next; ++at)
    if (*at != 0) return false;
  return followed->byte == 0xff;
}

/// Sets the bytes between a value's members to 0, where the compiler knows them. Otherwise, lists of launches
/// may differ without reason, and fewer graphs are used.
template <class T>
void clear_padding(T& value) {
  static const bool is_known = knows_padding<T>();
  if (is_known) __builtin_clear_padding(&value);
}

#else

template <class T>
void clear_padding(T&) {}

#endif

}  // namespace meniscus::pbd
