// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the visitors of fields() share: which kind of member they are looking at.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "sdk/fields/rule.h"

namespace meniscus {

/// Visits nothing; it only asks whether fields() or choices() takes a type.
struct NullVisitor {
  template <class T>
  void operator()(const char*, T&, const FieldRule&, const char*, const char*) {}
  template <class T, class Whole>
  void choice(const char*, T, Whole&, const char*) {}
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) {}
};

/// A key that files no longer have, and what to do about it.
struct RetiredKey {
  const char* name;
  const char* advice;
};

template <class T>
concept HasRetiredKeys = requires(const T& value) {
  retired_keys(value);
};

/// A visitor that looks at the structs as C++ has them. All other visitors look at the objects of a file.
template <class V>
concept OfMembers = V::of_members;

template <class T>
concept HasNames = requires(T value) {
  names_of(value);
};
template <class T>
concept HasFields = requires(NullVisitor& v, T& value) {
  fields(v, value);
};
template <class T>
concept HasChoices = requires(NullVisitor& v, T& value) {
  choices(v, value);
};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};

template <class T>
struct IsVariant : std::false_type {};
template <class... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

/// Visits a member whose own members are keys of the enclosing object in a file.
template <class V, class T>
void flat(V& v, const char* member, T& part) {
  if constexpr (OfMembers<V>)
    v.flat(member, part);
  else
    fields(v, part);
}

// Whether a reference to another thing is set. It is a name in a file, and an id in C++.
inline bool is_given(const std::string& name) {
  return !name.empty();
}
template <class Id>
bool is_given(const std::optional<Id>& id) {
  return id.has_value();
}

}  // namespace meniscus
