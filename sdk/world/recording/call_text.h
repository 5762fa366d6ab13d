// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calls of World and their arguments as they stand in recordings: CBOR, with arrays as bytes.
#pragma once

#include <meniscus/error.h>

#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sdk/world/state/definition_json.h"

namespace meniscus::call_text {

using definition_json::Ids;
using definition_json::Json;

template <class T>
struct IsSpan : std::false_type {};
template <class T>
struct IsSpan<std::span<T>> : std::true_type {
  using Element = std::remove_const_t<T>;
};

/// What holds an argument of a call while it is replayed.
template <class T, class Plain = std::remove_cvref_t<T>>
struct Held {
  using Type = Plain;
};
template <class T, class Element>
struct Held<T, std::span<Element>> {
  using Type = std::vector<std::remove_const_t<Element>>;
};

template <class T>
Json encode(const T& value, const Ids& ids) {
  if constexpr (IsSpan<T>::value) {
    const auto* const bytes = reinterpret_cast<const uint8_t*>(value.data());
    return Json::binary(std::vector<uint8_t>(bytes, bytes + value.size_bytes()));
  } else {
    T copy = value;  // fields() takes a mutable struct
    return definition_json::to_json(copy, ids);
  }
}

template <class T>
T decode(const Json& json, const Ids& ids) {
  if constexpr (IsList<T>::value) {
    using Element = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Element>);
    if (!json.is_binary() || json.get_binary().size() % sizeof(Element) != 0)
      throw Error(ErrorCode::io, "a call of the recording lacks a valid array");
    const std::vector<uint8_t>& bytes = json.get_binary();
    T values(bytes.size() / sizeof(Element));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  } else {
    T value{};
    definition_json::from_json(json, "argument", value, ids);
    return value;
  }
}

/// The name of a call, and its arguments.
template <class... Args>
std::vector<uint8_t> encoded(const char* name, const Ids& ids, const Args&... args) {
  Json call = Json::array();
  call.push_back(name);
  (call.push_back(encode(args, ids)), ...);
  return Json::to_cbor(call);
}

}  // namespace meniscus::call_text
