// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Members of definitions as Python objects.
#pragma once

#include <nanobind/nanobind.h>

#include <charconv>
#include <cstdlib>
#include <string>

#include "sdk/python/values/members.h"

namespace meniscus::python {

namespace nb = nanobind;

/// The double that a person would write for a float: 0.05, not 0.05000000074505806.
inline double plain_number(float x) {
  char text[32];
  *std::to_chars(text, text + sizeof text - 1, x).ptr = 0;
  return std::strtod(text, nullptr);
}

inline nb::object to_python(float x) {
  return nb::float_(plain_number(x));
}
inline nb::object to_python(int x) {
  return nb::int_(x);
}
inline nb::object to_python(uint32_t x) {
  return nb::int_(x);
}
inline nb::object to_python(uint64_t x) {
  return nb::int_(x);
}
inline nb::object to_python(double x) {
  return nb::float_(x);
}
inline nb::object to_python(bool x) {
  return nb::bool_(x);
}
inline nb::object to_python(const std::string& x) {
  return nb::str(x.data(), x.size());
}
inline nb::object to_python(Vec3 v) {
  return nb::make_tuple(to_python(v.x), to_python(v.y), to_python(v.z));
}
inline nb::object to_python(Quat q) {
  return nb::make_tuple(to_python(q.x), to_python(q.y), to_python(q.z), to_python(q.w));
}
template <HasNames E>
nb::object to_python(E value) {
  for (const Named<E>& named : names_of(value)) {
    if (named.value == value) return nb::str(named.name);
  }
  return nb::none();
}
template <class T>
nb::object to_python(const std::optional<T>& value);
template <class T>
nb::object to_python(const std::vector<T>& values);
template <class... T>
nb::object to_python(const std::variant<T...>& value);
/// A copy: objects of definitions do not change.
template <class T>
requires HasFields<T> nb::object to_python(const T& value) {
  return nb::cast(value, nb::rv_policy::copy);
}
template <class T>
nb::object to_python(const std::optional<T>& value) {
  return value ? to_python(*value) : nb::none();
}
template <class T>
nb::object to_python(const std::vector<T>& values) {
  nb::list list;
  for (const T& value : values) list.append(to_python(value));
  return list;
}
template <class... T>
nb::object to_python(const std::variant<T...>& value) {
  return std::visit([](const auto& held) { return to_python(held); }, value);
}

}  // namespace meniscus::python
