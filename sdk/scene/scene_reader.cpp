// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads a scene from JSON by the fields of scene_fields.h.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "sdk/fields/visitor.h"
#include "sdk/scene/closest_name.h"
#include "sdk/scene/scene_fields.h"
#include "sdk/scene/scene_file.h"
#include "sdk/scene/scene_names.h"
#include "sdk/scene/scene_values.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

template <class T>
void read_value(const Json& json, const ScenePlace& place, const FieldRule& rule, T& value);
template <class T>
void read_fields(const Json& object, const ScenePlace& place, T& value, std::vector<std::string> other_keys);

/// Gathers the keys that an object may have.
struct KeyCollector : NullVisitor {
  std::vector<std::string> keys;

  template <class T>
  void operator()(const char* key, T&, const FieldRule&, const char*, const char*) {
    keys.push_back(key);
  }
};

class FieldReader {
 public:
  FieldReader(const Json& object, const ScenePlace& place) : object_(object), place_(place) {}

  template <class T>
  void operator()(const char* key, T& value, const FieldRule& rule, const char*, const char* text) {
    const auto found = object_.find(key);
    if (found != object_.end()) {
      read_value(*found, place_.key(key), rule, value);
    } else if (rule.needed) {
      place_.key(key).fail(std::string("missing, and needed: ") + text);
    }
  }

  template <class... Subject>
  void check(bool ok, const std::string& message, const Subject&...) const {
    if (!ok) place_.fail(message);
  }

 private:
  const Json& object_;
  const ScenePlace& place_;
};

/// Reads the alternative that "type" names, and none of the others.
class ChoiceReader {
 public:
  ChoiceReader(const Json& object, const ScenePlace& place) : object_(object), place_(place) {
    const auto found = object.find("type");
    if (found != object.end()) read_plain(*found, place.key("type"), not_empty, type_);
  }

  template <class T, class Whole>
  void choice(const char* name, T value, Whole& whole, const char*) {
    names_.push_back(name);
    if (name != type_) return;
    read_fields(object_, place_, value, {"type"});
    whole = std::move(value);
    chosen_ = true;
  }

  void finish() const {
    if (chosen_) return;
    const std::string problem = type_.empty() ? "missing, and needed" : shown(type_) + " is not known";
    place_.key("type").fail(problem, name_hint(type_, names_));
  }

 private:
  const Json& object_;
  const ScenePlace& place_;
  std::string type_;
  std::vector<std::string> names_;
  bool chosen_ = false;
};

void expect_object(const Json& json, const ScenePlace& place) {
  if (!json.is_object()) place.fail(shown(json) + " is not allowed", "must be an object {...}");
}

/// Reads the keys that fields() lists; one that is neither there nor in `other_keys` is an error.
template <class T>
void read_fields(const Json& object, const ScenePlace& place, T& value, std::vector<std::string> other_keys) {
  KeyCollector known;
  known.keys = std::move(other_keys);
  fields(known, value);
  for (const auto& [key, ignored] : object.items()) {
    if (std::find(known.keys.begin(), known.keys.end(), key) != known.keys.end()) continue;
    if constexpr (HasRetiredKeys<T>) {
      for (const RetiredKey& old : retired_keys(value)) {
        if (key == old.name) place.key(key).fail(old.advice);
      }
    }
    place.key(key).fail("unknown key", name_hint(key, known.keys));
  }
  FieldReader reader(object, place);
  fields(reader, value);
}

template <class T>
void read_choice(const Json& json, const ScenePlace& place, T& value) {
  expect_object(json, place);
  ChoiceReader reader(json, place);
  choices(reader, value);
  reader.finish();
}

template <class T>
void read_list(const Json& json, const ScenePlace& place, const FieldRule& rule, std::vector<T>& values) {
  if (!json.is_array()) place.fail(shown(json) + " is not allowed", "must be an array [...]");
  const auto refuse = [&](const char* bound, std::size_t items) {
    place.fail(shown(json) + " is not allowed",
               std::string("must have ") + bound + std::to_string(items) + " items");
  };
  if (json.size() < rule.min_items) refuse("at least ", rule.min_items);
  if (json.size() > rule.max_items) refuse("at most ", rule.max_items);
  values.assign(json.size(), T{});
  for (std::size_t i = 0; i < json.size(); ++i) read_value(json[i], place.item(i), of_item(rule), values[i]);
}

template <class E>
void read_name(const Json& json, const ScenePlace& place, E& value) {
  const std::string word = json.is_string() ? json.get<std::string>() : std::string();
  std::vector<std::string> names;
  for (const Named<E>& named : names_of(value)) {
    names.push_back(named.name);
    if (word == named.name) return void(value = named.value);
  }
  place.fail(shown(json) + " is not known", name_hint(word, names));
}

void read_rotation(const Json& json, const ScenePlace& place, const FieldRule& rule, Quat& value) {
  if (!json.is_object()) return read_plain(json, place, rule, value);
  AxisAngle turn;
  read_fields(json, place, turn, {});
  const double half = turn.degrees * std::numbers::pi / 360;
  const Vec3 axis = float(std::sin(half)) * (turn.axis / length(turn.axis));
  value = {axis.x, axis.y, axis.z, float(std::cos(half))};
}

template <class T>
void read_value(const Json& json, const ScenePlace& place, const FieldRule& rule, T& value) {
  if constexpr (IsOptional<T>::value) {
    read_value(json, place, rule, value.emplace());
  } else if constexpr (IsList<T>::value) {
    read_list(json, place, rule, value);
  } else if constexpr (HasNames<T>) {
    read_name(json, place, value);
  } else if constexpr (HasChoices<T>) {
    read_choice(json, place, value);
  } else if constexpr (HasFields<T>) {
    expect_object(json, place);
    read_fields(json, place, value, {});
  } else if constexpr (std::is_same_v<T, Quat>) {
    read_rotation(json, place, rule, value);
  } else {
    read_plain(json, place, rule, value);
  }
}

}  // namespace

Scene parse_scene(const Json& document, const std::string& source) {
  Scene scene;
  read_value(document, ScenePlace{source, ""}, any_value, scene);
  check_names(scene, source);
  return scene;
}

}  // namespace meniscus
