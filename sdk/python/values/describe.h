// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Signatures and docstrings of calls that take the members of a definition, by its fields().
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "sdk/python/values/to_python.h"

namespace meniscus::python {

inline std::string type_text(float) {
  return "float";
}
inline std::string type_text(int) {
  return "int";
}
inline std::string type_text(uint32_t) {
  return "int";
}
inline std::string type_text(bool) {
  return "bool";
}
inline std::string type_text(const std::string&) {
  return "str";
}
inline std::string type_text(Vec3) {
  return "numpy.typing.ArrayLike";
}
inline std::string type_text(Quat) {
  return "numpy.typing.ArrayLike";
}
template <class Tag>
std::string type_text(Id<Tag> id) {
  return handle_name(id);
}
template <HasNames E>
std::string type_text(E value) {
  std::string text;
  for (const Named<E>& named : names_of(value))
    text += (text.empty() ? "typing.Literal['" : ", '") + std::string(named.name) + "'";
  return text + "]";
}
template <class T>
requires HasFields<T> std::string type_text(T&) {
  std::string text = std::string(type_name<T>()) + " | dict[str, typing.Any]";
  return std::is_same_v<T, Pose> ? text + " | numpy.typing.ArrayLike" : text;
}

struct ChoiceText {
  std::string text{}, meanings{};

  template <class T, class Whole>
  void choice(const char*, const T&, Whole&, const char* meaning) {
    text += (text.empty() ? "" : " | ") + std::string(type_name<T>());
    meanings += "\n        " + std::string(type_name<T>()) + ": " + meaning;
  }
};

template <class T>
requires HasChoices<T> std::string type_text(T& value) {
  ChoiceText choice;
  choices(choice, value);
  return choice.text;
}
template <class T>
std::string type_text(std::optional<T>&) {
  T inner{};
  return type_text(inner) + " | None";
}
template <class T>
std::string type_text(std::vector<T>&) {
  T item{};
  if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, Vec3>) return "numpy.typing.ArrayLike";
  return "collections.abc.Sequence[" + type_text(item) + "]";
}

/// What a property returns, where that is less than what it takes.
template <class T>
std::string result_text(T& value) {
  if constexpr (std::is_same_v<T, Vec3>) return "tuple[float, float, float]";
  if constexpr (std::is_same_v<T, Quat>) return "tuple[float, float, float, float]";
  if constexpr (HasFields<T>) return std::string(type_name<T>());
  if constexpr (IsOptional<T>::value) {
    typename T::value_type inner{};
    return result_text(inner) + " | None";
  } else if constexpr (IsList<T>::value) {
    typename T::value_type item{};
    return "list[" + result_text(item) + "]";
  } else {
    return type_text(value);
  }
}

std::string bounds_text(const FieldRule& rule);
/// The default as Python shows it, or "..." for what is no plain value.
template <class T>
std::string default_text(const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string> || HasNames<T>) {
    if constexpr (std::is_same_v<T, float>) {
      if (!std::isfinite(value)) return "float('inf')";
    }
    return nb::cast<std::string>(nb::repr(to_python(value)));
  } else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Quat>) {
    return nb::cast<std::string>(nb::repr(to_python(value)));
  } else if constexpr (IsOptional<T>::value) {
    return "None";
  } else {
    return "...";
  }
}

/// One line on a member: unit, meaning, range, default.
template <class T>
std::string member_doc(const char* key, T& value, const FieldRule& rule, const char* unit,
                       const char* meaning) {
  std::string text =
      meaning == mesh_file_text ? "path of an OBJ, PLY, STL, glTF, FBX, DAE or 3DS file" : meaning;
  if (const auto at = text.find("from the scene's folder: "); at != std::string::npos)
    text.replace(at, std::string("from the scene's folder").size(), "path");
  if (const auto at = text.find("name of "); at != std::string::npos && !std::is_same_v<T, std::string>)
    text.erase(at, std::string("name of ").size());
  const std::string shown_unit = rule.in_degrees ? "rad" : unit;
  std::string doc = std::string(key) + (shown_unit.empty() ? "" : " (" + shown_unit + ")") + ": " + text;
  if (const std::string bounds = bounds_text(rule); !bounds.empty()) doc += "; " + bounds;
  const std::string usual = default_text(value);
  if (!is_needed(value, rule) && usual != "..." && usual != "''") doc += "; default " + usual;
  if constexpr (HasChoices<T>) {
    ChoiceText choice;
    choices(choice, value);
    doc += choice.meanings;
  }
  return doc;
}

/// A signature and a docstring, for nanobind and its stubs.
struct Description {
  std::string signature, doc;
};

/// Of a call with the members of a definition as keyword arguments. `optional`: any of them may be left out.
template <class D>
Description describe_call(const std::string& name, const std::string& result, const std::string& summary,
                          bool optional = false) {
  D def{};
  Description text{"def " + name + "(self", summary + "\n\nArgs:"};
  bool first = true;
  for_any_member(
      def, [&](const char* key, auto& value, const FieldRule& rule, const char* unit, const char* meaning) {
        text.signature +=
            (std::exchange(first, false) ? ", *, " : ", ") + std::string(key) + ": " + type_text(value);
        if (optional)
          text.signature += " = ...";
        else if (!is_needed(value, rule))
          text.signature += " = " + default_text(value);
        text.doc += "\n    " + member_doc(key, value, rule, unit, meaning);
      });
  text.signature += ") -> " + result;
  if (first) text.doc = summary;
  return text;
}

}  // namespace meniscus::python
