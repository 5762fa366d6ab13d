// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Read-only NumPy arrays of memory that C++ owns.
#pragma once

#include <nanobind/ndarray.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/python/state/world_state.h"

namespace meniscus::python {

using Owner = std::shared_ptr<const void>;

/// The owner as an object that arrays keep alive.
inline nb::capsule kept(Owner owner) {
  return nb::capsule(new Owner(std::move(owner)),
                     [](void* memory) noexcept { delete static_cast<Owner*>(memory); });
}

/// `count` rows of `width` numbers, each `stride` numbers behind the one before; a width of 0 is one number
/// in place of a row.
template <class T>
nb::object rows(const T* first, std::size_t count, std::size_t width, std::size_t stride, nb::handle owner) {
  using Array = nb::ndarray<nb::numpy, const T>;
  const std::size_t shape[] = {count, width};
  const int64_t strides[] = {static_cast<int64_t>(stride), 1};
  return nb::cast(Array(first, width ? 2 : 1, shape, owner, strides));
}

template <class T>
nb::object array_of(std::span<const T> values, nb::handle owner) {
  return rows(values.data(), values.size(), 0, 1, owner);
}
inline nb::object array_of(std::span<const Vec3> values, nb::handle owner) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return rows(reinterpret_cast<const float*>(values.data()), values.size(), 3, 3, owner);
}
inline nb::object array_of(std::span<const Quat> values, nb::handle owner) {
  static_assert(sizeof(Quat) == 4 * sizeof(float));
  return rows(reinterpret_cast<const float*>(values.data()), values.size(), 4, 4, owner);
}

/// An array that takes over a vector.
template <class T>
nb::object array_of(std::vector<T> values) {
  const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
  return array_of(std::span<const T>(*owner), kept(owner));
}

/// An array of a read-out that the world keeps elsewhere: a copy.
template <class T>
nb::object copied(std::span<const T> values) {
  return array_of(std::vector<T>(values.begin(), values.end()));
}

/// An array of a read-out of particles: the world's own memory.
template <class T>
nb::object held(const World& world, std::span<const T> values) {
  if (values.empty()) return copied(values);
  return array_of(values, kept(world.hold(values.data())));
}

}  // namespace meniscus::python
