// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the two visitors of scene_fields.h share: which kind of member they are looking at.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "sdk/scene/scene_fields.h"

namespace meniscus {

/// Visits nothing; it only asks whether fields() or choices() takes a type.
struct NullVisitor {
  template <class T>
  void operator()(const char*, T&, const FieldRule&, const char*, const char*) {}
  template <class T, class Whole>
  void choice(const char*, T, Whole&, const char*) {}
  void check(bool, const std::string&) {}
};

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

}  // namespace meniscus
