// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds all numbers of a definition by its fields(), and where they stand in a scene file.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sdk/world/check/member_check.h"

namespace meniscus::tests {

/// A number of a definition, or of a vector's components the first.
struct Number {
  std::string name;  ///< as errors call it
  nlohmann::json::json_pointer place;
  FieldRule rule;
  bool is_whole = false, is_signed = true, is_rotation = false;
  std::function<void(double)> set;  ///< the member, to a value in the unit of files
  std::function<void()> reset;
};

/// Visits a definition as C++ has it.
class NumberWalk {
 public:
  static constexpr bool of_members = true;
  using Pointer = nlohmann::json::json_pointer;

  NumberWalk(const Pointer& place, const std::string& prefix, std::vector<Number>& numbers)
      : place_(place), prefix_(prefix), numbers_(numbers) {}

  template <class T>
  void operator()(const char* member, T& value, const FieldRule& rule, const char*, const char*) {
    if (!rule.key_only) visit(place_ / std::string(member), prefix_ + member, value, rule);
  }
  template <class T>
  void flat(const char* member, T& part) {
    visit(place_, prefix_ + member, part, any_value);
  }
  template <class T, class Whole>
  void choice(const char*, const T&, Whole& whole, const char*) {
    if (T* const chosen = std::get_if<T>(&whole)) visit(place_, prefix_, *chosen, any_value);
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) {}

 private:
  template <class T>
  void visit(const Pointer& place, const std::string& name, T& value, const FieldRule& rule) {
    if constexpr (IsOptional<T>::value) {
      if (value) visit(place, name, *value, rule);
    } else if constexpr (IsList<T>::value) {
      if (!value.empty()) visit(place / 0, name + "[0]", value[0], of_item(rule));
    } else if constexpr (HasChoices<T>) {
      NumberWalk inner(place, name, numbers_);
      choices(inner, value);
    } else if constexpr (HasFields<T> || std::is_same_v<T, ProbeDef>) {
      const std::string type = std::string(type_name<T>()) + "::";
      NumberWalk inner(place, check::is_plain<T> ? name + "." : type, numbers_);
      fields(inner, value);
    } else if constexpr (std::is_same_v<T, Vec3>) {
      add(place / 0, name, value.x, rule);
    } else if constexpr (std::is_same_v<T, Quat>) {
      add(place, name, value.x, rule);
      numbers_.back().is_rotation = true;
    } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      add(place, name, value, rule);
    } else {
      static_assert(check::is_free<T> || HasNames<T>, "a kind of member that is not tested");
    }
  }

  template <class T>
  void add(const Pointer& place, const std::string& name, T& value, const FieldRule& rule) {
    const auto set = [&value, rule](double x) { value = static_cast<T>(x * double{unit_of(rule)}); };
    const auto reset = [&value, before = value] { value = before; };
    numbers_.push_back({name, place, rule, std::is_integral_v<T>, std::is_signed_v<T>, false, set, reset});
  }

  Pointer place_;
  std::string prefix_;
  std::vector<Number>& numbers_;
};

template <class Def>
std::vector<Number> numbers_of(Def& def, const std::string& place) {
  std::vector<Number> numbers;
  NumberWalk walk(nlohmann::json::json_pointer(place), std::string(type_name<Def>()) + "::", numbers);
  fields(walk, def);
  return numbers;
}

}  // namespace meniscus::tests
