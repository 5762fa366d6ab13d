// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the ids in a definition by its fields().
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sdk/world/check/member_check.h"

namespace meniscus::tests {

/// An id of a definition. `set` makes it another one, for which no create call need have returned.
struct IdMember {
  std::string name;
  std::function<void(uint32_t index, uint32_t generation)> set;
};

class IdWalk {
 public:
  static constexpr bool of_members = true;

  explicit IdWalk(std::vector<IdMember>& ids) : ids_(ids) {}

  template <class T>
  void operator()(const char* member, T& value, const FieldRule&, const char*, const char*) {
    if constexpr (requires { value.generation; }) {
      ids_.push_back({member, [&value](uint32_t i, uint32_t g) { value = {i, g}; }});
    } else if constexpr (IsOptional<T>::value && requires { value->generation; }) {
      if (value) ids_.push_back({member, [&value](uint32_t i, uint32_t g) { value = {{i, g}}; }});
    }
  }
  template <class T>
  void flat(const char*, T&) {}
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) {}

 private:
  std::vector<IdMember>& ids_;
};

template <class Def>
std::vector<IdMember> ids_of(Def& def) {
  std::vector<IdMember> ids;
  IdWalk walk(ids);
  fields(walk, def);
  return ids;
}

}  // namespace meniscus::tests
