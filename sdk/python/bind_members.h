// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Properties for the members of a definition.
#pragma once

#include <string>
#include <type_traits>

#include "sdk/python/values/describe.h"
#include "sdk/python/values/from_python.h"

namespace meniscus::python {

template <class D>
std::ptrdiff_t offset_in(D& def, const void* member) {
  return static_cast<const char*>(member) - reinterpret_cast<const char*>(&def);
}
template <class T, class D>
T& member_at(D& def, std::ptrdiff_t offset) {
  return *reinterpret_cast<T*>(reinterpret_cast<char*>(&def) + offset);
}

template <class T>
std::string getter_text(const char* key, T& value) {
  return "def " + std::string(key) + "(self) -> " + result_text(value);
}

/// A property for each member of a definition that a running object has. Names are those at the creation.
template <class D, class Self, class Get, class Set>
void bind_members(nb::class_<Self>& type, const Get& get, const Set& set) {
  D usual{};
  for_each_member(
      usual, [&](const char* key, auto& value, const FieldRule& rule, const char* unit, const char* meaning) {
        using Value = std::decay_t<decltype(value)>;
        if (std::string_view(key) == "name") return;
        const std::ptrdiff_t offset = offset_in(usual, &value);
        const Description text{getter_text(key, value), member_doc(key, value, rule, unit, meaning)};
        const std::string setter_text =
            "def " + std::string(key) + "(self, value: " + type_text(value) + ", /) -> None";
        type.def_prop_rw(
            key,
            [offset, get](Self& self) {
              D def = get(self);
              return to_python(member_at<Value>(def, offset));
            },
            [offset, get, set, key](Self& self, nb::handle given) {
              D def = get(self);
              read(given, {std::string(type_name<D>()), key}, member_at<Value>(def, offset));
              set(self, def);
            },
            nb::for_getter(nb::sig(text.signature.c_str())), nb::for_setter(nb::sig(setter_text.c_str())),
            text.doc.c_str());
      });
}

}  // namespace meniscus::python
