// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definitions as JSON and back, by their fields(). Every member is written, and reading gives the same bits.
#pragma once

#include <meniscus/error.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

#include "sdk/fields/fields.h"
#include "sdk/world/state/whole_number.h"

namespace meniscus::definition_json {

using Json = nlohmann::ordered_json;

[[noreturn]] inline void refuse(const std::string& key) {
  throw Error(ErrorCode::io, "the definitions in the file lack a valid \"" + key + "\"");
}

template <class T>
constexpr bool is_id = requires(T id) {
  id.generation;
};

/// Generations in files count from 0.
struct Ids {
  uint32_t first_generation = 0;
};

template <class T>
Json to_json(T& value, const Ids& ids);
template <class T>
void from_json(const Json& json, const std::string& key, T& value, const Ids& ids);

inline const Json& at(const Json& object, const std::string& key) {
  if (!object.is_object() || !object.contains(key)) refuse(key);
  return object[key];
}

// JSON has no infinity.
inline Json of_float(float x) {
  if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
  return x;
}
inline float to_float(const Json& json, const std::string& key) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (json == "infinity") return infinity;
  if (json == "-infinity") return -infinity;
  if (!json.is_number()) refuse(key);
  return json.get<float>();
}

class Writer {
 public:
  static constexpr bool of_members = true;
  explicit Writer(const Ids& ids) : ids_(ids) {}

  template <class T>
  void operator()(const char* key, T& value, const FieldRule& rule, const char*, const char*) {
    if (!rule.key_only) json[key] = to_json(value, ids_);
  }
  template <class T>
  void flat(const char* member, T& part) {
    json[member] = to_json(part, ids_);
  }
  template <class T, class Whole>
  void choice(const char* name, const T&, Whole& whole, const char*) {
    T* const chosen = std::get_if<T>(&whole);
    if (!chosen) return;
    fields(*this, *chosen);
    json["type"] = name;
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) const {}

  Json json = Json::object();

 private:
  const Ids& ids_;
};

class Reader {
 public:
  static constexpr bool of_members = true;
  Reader(const Json& json, const Ids& ids) : json_(json), ids_(ids) {}

  template <class T>
  void operator()(const char* key, T& value, const FieldRule& rule, const char*, const char*) {
    if (rule.key_only || lacks(key)) return;
    from_json(json_[key], key, value, ids_);
  }
  template <class T>
  void flat(const char* member, T& part) {
    if (!lacks(member)) from_json(json_[member], member, part, ids_);
  }
  template <class T, class Whole>
  void choice(const char* name, T value, Whole& whole, const char*) {
    if (at(json_, "type") != name) return;
    fields(*this, value);
    whole = std::move(value);
    chosen = true;
  }
  template <class... Subject>
  void check(bool, const std::string&, const Subject&...) const {}

  bool chosen = false;  ///< an alternative

 private:
  /// A member that an earlier version did not have keeps its default.
  bool lacks(const std::string& key) const {
    if (!json_.is_object()) refuse(key);
    return !json_.contains(key);
  }

  const Json& json_;
  const Ids& ids_;
};

template <class E>
Json name_of(E value) {
  for (const Named<E>& named : names_of(value)) {
    if (named.value == value) return named.name;
  }
  return nullptr;
}
template <class E>
E value_of(const Json& json, const std::string& key) {
  for (const Named<E>& named : names_of(E{})) {
    if (json == named.name) return named.value;
  }
  refuse(key);
}

template <class T>
Json to_json(T& value, const Ids& ids) {
  if constexpr (IsOptional<T>::value) {
    return value ? to_json(*value, ids) : Json(nullptr);
  } else if constexpr (IsList<T>::value) {
    Json list = Json::array();
    for (auto& item : value) list.push_back(to_json(item, ids));
    return list;
  } else if constexpr (is_id<T>) {
    return {value.index, value.generation - ids.first_generation};
  } else if constexpr (HasNames<T>) {
    return name_of(value);
  } else if constexpr (HasChoices<T>) {
    Writer writer(ids);
    choices(writer, value);
    return writer.json;
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return {of_float(value.x), of_float(value.y), of_float(value.z)};
  } else if constexpr (std::is_same_v<T, Quat>) {
    return {value.x, value.y, value.z, value.w};
  } else if constexpr (std::is_same_v<T, float>) {
    return of_float(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else {
    Writer writer(ids);
    fields(writer, value);
    return writer.json;
  }
}

template <class T>
void from_json(const Json& json, const std::string& key, T& value, const Ids& ids) {
  if constexpr (IsOptional<T>::value) {
    if (json.is_null()) return value.reset();
    from_json(json, key, value.emplace(), ids);
  } else if constexpr (IsList<T>::value) {
    if (!json.is_array()) refuse(key);
    value.assign(json.size(), {});
    for (std::size_t k = 0; k < json.size(); ++k) from_json(json[k], key, value[k], ids);
  } else if constexpr (is_id<T>) {
    if (!json.is_array() || json.size() != 2) refuse(key);
    const auto index = whole_number<uint32_t>(json[0]), generation = whole_number<uint32_t>(json[1]);
    if (!index || !generation) refuse(key);
    value = {*index, *generation + ids.first_generation};
  } else if constexpr (HasNames<T>) {
    value = value_of<T>(json, key);
  } else if constexpr (HasChoices<T>) {
    Reader reader(json, ids);
    choices(reader, value);
    if (!reader.chosen) refuse(key);
  } else if constexpr (std::is_same_v<T, Vec3>) {
    if (!json.is_array() || json.size() != 3) refuse(key);
    value = {to_float(json[0], key), to_float(json[1], key), to_float(json[2], key)};
  } else if constexpr (std::is_same_v<T, Quat>) {
    if (!json.is_array() || json.size() != 4) refuse(key);
    value = {to_float(json[0], key), to_float(json[1], key), to_float(json[2], key), to_float(json[3], key)};
  } else if constexpr (std::is_same_v<T, float>) {
    value = to_float(json, key);
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!json.is_boolean()) refuse(key);
    value = json.get<bool>();
  } else if constexpr (std::is_integral_v<T>) {
    const auto whole = whole_number<T>(json);
    if (!whole) refuse(key);
    value = *whole;
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!json.is_number()) refuse(key);
    value = json.get<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) refuse(key);
    value = json.get<std::string>();
  } else {
    Reader reader(json, ids);
    fields(reader, value);
  }
}

}  // namespace meniscus::definition_json
