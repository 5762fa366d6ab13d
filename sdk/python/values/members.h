// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Visits the members of a definition struct as Python has them: the members of flat parts are its own.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "sdk/fields/fields.h"
#include "sdk/fields/type_name.h"

namespace meniscus::python {

/// Calls visit(key, member, rule, unit, meaning) for each member.
template <class Visit>
struct MemberVisitor {
  static constexpr bool of_members = true;

  const Visit& visit;

  template <class T>
  void operator()(const char* key, T& value, const FieldRule& rule, const char* unit, const char* meaning) {
    if (!rule.key_only) visit(key, value, rule, unit, meaning);
  }
  template <class T>
  void flat(const char* key, T& part) {
    if constexpr (HasChoices<T> || IsOptional<T>::value)
      visit(key, part, any_value, "", "which one");
    else
      fields(*this, part);
  }
  /// World checks definitions.
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) {}
};

template <class D, class Visit>
void for_each_member(D& def, const Visit& visit) {
  MemberVisitor<Visit> visitor{visit};
  fields(visitor, def);
}

/// The members that any value of the struct has. A probe has other members for each kind.
template <class D, class Visit>
void for_any_member(D& def, const Visit& visit) {
  if constexpr (std::is_same_v<D, ProbeDef>) {
    std::set<std::string_view> seen;
    for (const Named<ProbeKind>& kind : names_of(ProbeKind{})) {
      def.kind = kind.value;
      for_each_member(
          def, [&](const char* key, auto& value, FieldRule rule, const char* unit, const char* meaning) {
            rule.needed = false;
            if (seen.insert(key).second) visit(key, value, rule, unit, meaning);
          });
    }
  } else {
    for_each_member(def, visit);
  }
}

/// Whether a call must have this argument. Names are optional: only files refer to things by name.
template <class T>
bool is_needed(const T&, const FieldRule& rule) {
  return rule.needed && !(std::is_same_v<T, std::string> && rule.min_items > 0);
}

/// Where a member is stored: fields() wraps a geometry to tell which alternatives it may be.
template <class T>
T& stored(T& value) {
  return value;
}
inline Geometry& stored(BodyGeometry& wrapped) {
  return wrapped.geometry;
}
inline Geometry& stored(PartGeometry& wrapped) {
  return wrapped.geometry;
}

template <class T>
struct IsId : std::false_type {};
template <class Tag>
struct IsId<Id<Tag>> : std::true_type {};

/// "Body" for BodyId.
template <class Tag>
std::string handle_name(Id<Tag>) {
  const std::string_view tag = type_name<Tag>();
  return std::string(tag.substr(0, tag.size() - std::string_view("Tag").size()));
}

}  // namespace meniscus::python
