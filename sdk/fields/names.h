// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Words for enumerators. names_of(E) lists those of an enumeration.
#pragma once

#include <meniscus/axis.h>

#include <array>
#include <string>

namespace meniscus {

/// An enumerator and its word in a scene file.
template <class E>
struct Named {
  const char* name;
  E value;
};
template <class E>
Named(const char*, E) -> Named<E>;  // clang deduces aggregates from version 17 on

constexpr auto names_of(Axis) {
  return std::array{Named{"x", Axis::x}, Named{"y", Axis::y}, Named{"z", Axis::z}};
}

}  // namespace meniscus
