// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The name of a struct, for messages.
#pragma once

#include <string_view>

namespace meniscus {

namespace detail {

/// The compiler's name of this function, in which that of T stands.
template <class T>
constexpr std::string_view signature() {
#ifdef _MSC_VER
  return __FUNCSIG__;
#else
  return __PRETTY_FUNCTION__;
#endif
}

}  // namespace detail

/// "FluidDef" for meniscus::FluidDef.
template <class T>
constexpr std::string_view type_name() {
  constexpr std::string_view known = "double", pattern = detail::signature<double>();
  constexpr std::size_t before = pattern.rfind(known);
  constexpr std::size_t after = pattern.size() - before - known.size();
  const std::string_view signature = detail::signature<T>();
  const std::string_view name = signature.substr(before, signature.size() - before - after);
  return name.substr(name.rfind(':') + 1);
}

}  // namespace meniscus
