// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The visitor of fields() that checks a definition in C++. The reader of scene files is its counterpart.
#pragma once

#include <meniscus/error.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>

#include "pbd/math/vec.h"
#include "sdk/fields/fields.h"
#include "sdk/fields/type_name.h"
#include "sdk/world/check/check.h"

namespace meniscus::check {

/// The name of a value in errors: `FluidDef::color`, `BodyDef::pose.position`, `RopeDef::points[2]`. It is a
/// chain of owners, so that the text is made only when a value is refused.
struct Place {
  std::string_view name;
  const Place* owner = nullptr;
  std::ptrdiff_t item = -1;  ///< index in a list; the owner is the list
  const char* mark = ".";    ///< between it and its members

  template <class T>
  static Place of_type() {
    return {type_name<T>(), nullptr, -1, "::"};
  }

  std::string text() const;
};

/// What a value may be.
struct Limits {
  const FieldRule& rule;
  const char* unit;
  const char* meaning;
};

void check_number(const Place& place, float value, const Limits& limits);
void check_number(const Place& place, int value, const Limits& limits);
void check_number(const Place& place, uint32_t value, const Limits& limits);
void check_number(const Place& place, Vec3 value, const Limits& limits);
void check_number(const Place& place, Quat value, const Limits& limits);  ///< must be of length 1
void check_count(const Place& place, std::size_t count, const FieldRule& rule);

template <class T>
void check_value(const Place& place, T& value, const Limits& limits);

/// The value as errors show it.
template <class T>
std::string shown(const T& value) {
  if constexpr (IsOptional<T>::value) {
    return value ? shown(*value) : "left out";
  } else if constexpr (IsList<T>::value) {
    return value.empty() ? "empty" : "a list of " + std::to_string(value.size());
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return text_of(value);
  } else {
    return (std::ostringstream() << value).str();
  }
}

class MemberCheck {
 public:
  static constexpr bool of_members = true;

  explicit MemberCheck(const Place& place) : place_(place) {}

  template <class T>
  void operator()(const char* member, T& value, const FieldRule& rule, const char* unit,
                  const char* meaning) const {
    if (!rule.key_only) check_value({member, &place_}, value, {rule, unit, meaning});
  }

  template <class T>
  void flat(const char* member, T& part) const {
    (*this)(member, part, any_value, "", "");
  }

  void check(bool ok, const std::string& message) const {
    if (!ok) fail(place_.text() + ": " + message);
  }
  void check(bool ok, const std::string& message, const char* member) const {
    if (!ok) fail(Place{member, &place_}.text() + ": " + message);
  }
  template <class T>
  void check(bool ok, const std::string& message, const char* member, const T& value) const {
    if (!ok) fail(Place{member, &place_}.text() + " is " + shown(value) + "; " + message);
  }

 private:
  [[noreturn]] static void fail(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message);
  }

  const Place& place_;
};

/// Tests the alternative that a variant holds.
class ChoiceCheck {
 public:
  explicit ChoiceCheck(const Place& place) : place_(place) {}

  template <class T, class Whole>
  void choice(const char* name, const T&, Whole& whole, const char*) {
    allowed_ += (allowed_.empty() ? "" : ", ") + std::string(name);
    held_ = std::visit([](const auto& v) { return type_name<std::decay_t<decltype(v)>>(); }, whole);
    T* const chosen = std::get_if<T>(&whole);
    if (!chosen) return;
    check_value(place_, *chosen, {any_value, "", ""});
    is_allowed_ = true;
  }

  void finish() const {
    if (!is_allowed_) refuse(place_.text(), "a " + std::string(held_), "one of: " + allowed_);
  }

 private:
  const Place& place_;
  std::string allowed_;
  std::string_view held_;
  bool is_allowed_ = false;
};

/// Types whose members errors name by the member that holds them, not by the type.
template <class T>
constexpr bool is_plain =
    std::is_same_v<T, Pose> || std::is_same_v<T, Aabb> || std::is_same_v<T, Range> ||
    std::is_same_v<T, CollisionFilter> || std::is_same_v<T, PeriodicDef> || std::is_same_v<T, PeriodicExtent>;

template <class T>
void check_fields(const Place& place, T& value) {
  MemberCheck check(place);
  fields(check, value);
}

template <class T>
void check_list(const Place& place, std::vector<T>& values, const Limits& limits) {
  check_count(place, values.size(), limits.rule);
  const FieldRule rule = of_item(limits.rule);
  for (std::size_t i = 0; i < values.size(); ++i)
    check_value({{}, &place, static_cast<std::ptrdiff_t>(i)}, values[i], {rule, limits.unit, limits.meaning});
}

template <class E>
void check_name(const Place& place, E value) {
  std::string allowed;
  for (const Named<E>& named : names_of(value)) {
    if (named.value == value) return;
    allowed += (allowed.empty() ? "" : ", ") + std::string(named.name);
  }
  refuse(place.text(), std::to_string(static_cast<int>(value)), "one of: " + allowed);
}

/// Text, bools and ids are not checked.
template <class T>
constexpr bool is_free = std::is_same_v<T, bool> || std::is_same_v<T, std::string> || requires(T id) {
  id.generation;
};

template <class T>
void check_value(const Place& place, T& value, const Limits& limits) {
  if constexpr (IsOptional<T>::value) {
    if (value) return check_value(place, *value, limits);
    if (limits.rule.needed) refuse(place.text(), "left out", std::string("there: ") + limits.meaning);
  } else if constexpr (IsList<T>::value) {
    check_list(place, value, limits);
  } else if constexpr (HasNames<T>) {
    check_name(place, value);
  } else if constexpr (HasChoices<T>) {
    ChoiceCheck check(place);
    choices(check, value);
    check.finish();
  } else if constexpr (is_plain<T>) {
    check_fields(place, value);
  } else if constexpr (!is_free<T>) {
    if constexpr (requires { check_number(place, value, limits); })
      check_number(place, value, limits);
    else
      check_fields(Place::of_type<T>(), value);
  }
}

/// fields() takes a mutable struct because readers write to it. A check writes nothing.
template <class Def>
void def(const Def& def) {
  check_fields(Place::of_type<Def>(), const_cast<Def&>(def));
}

}  // namespace meniscus::check
