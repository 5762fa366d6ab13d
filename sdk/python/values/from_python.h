// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads members of definitions from Python objects. What does not fit is a TypeError or a ValueError that
// names the member. World checks ranges.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <string>
#include <vector>

#include "sdk/python/state/handle.h"
#include "sdk/python/values/members.h"

namespace meniscus::python {

namespace nb = nanobind;

/// A value in messages: `add_body(): density`.
struct Place {
  std::string owner;  ///< a call or a class
  std::string member;

  std::string text() const { return owner + "(): " + member; }
};

/// Throws TypeError: `add_body(): density must be a number, not str`.
[[noreturn]] void refuse(const Place& place, const std::string& allowed, nb::handle given);
/// Throws TypeError for an argument that does not exist, and names the closest one.
[[noreturn]] void refuse_key(const std::string& owner, const std::string& key,
                             const std::vector<std::string>& known);

void read(nb::handle given, const Place& place, float& value);
void read(nb::handle given, const Place& place, int& value);
void read(nb::handle given, const Place& place, uint32_t& value);
void read(nb::handle given, const Place& place, bool& value);
void read(nb::handle given, const Place& place, std::string& value);
void read(nb::handle given, const Place& place, Vec3& value);
void read(nb::handle given, const Place& place, Quat& value);
/// From any sequence, buffer or DLPack array in the memory of the host.
void read(nb::handle given, const Place& place, std::vector<Vec3>& values);
void read(nb::handle given, const Place& place, std::vector<float>& values);
void read(nb::handle given, const Place& place, std::vector<uint32_t>& values);
void read(nb::handle given, const Place& place, std::vector<ParticleId>& values);

template <class Tag>
void read(nb::handle given, const Place& place, Id<Tag>& id) {
  const Handle<Id<Tag>>* handle = nullptr;
  if (!nb::try_cast(given, handle) || !handle) refuse(place, "a " + handle_name(id), given);
  id = handle->id;
}

template <HasNames E>
void read(nb::handle given, const Place& place, E& value) {
  std::string word, allowed;
  nb::try_cast(given, word);
  for (const Named<E>& named : names_of(value)) {
    if (nb::isinstance<nb::str>(given) && word == named.name) return void(value = named.value);
    allowed += (allowed.empty() ? "'" : ", '") + std::string(named.name) + "'";
  }
  if (!nb::isinstance<nb::str>(given)) refuse(place, "one of " + allowed, given);
  throw nb::value_error((place.text() + " must be one of " + allowed + ", not '" + word + "'").c_str());
}

template <class T>
requires HasFields<T>
void read(nb::handle given, const Place& place, T& value);
template <class T>
requires HasChoices<T>
void read(nb::handle given, const Place& place, T& value);
template <class T>
void read(nb::handle given, const Place& place, std::optional<T>& value) {
  if (given.is_none()) return value.reset();
  T read_value{};
  read(given, place, read_value);
  value = std::move(read_value);
}
template <class T>
void read(nb::handle given, const Place& place, std::vector<T>& values) {
  if (nb::isinstance<nb::str>(given) || !PySequence_Check(given.ptr())) refuse(place, "a sequence", given);
  values.clear();
  for (const nb::handle item : nb::iter(given))
    read(item, {place.owner, place.member + "[" + std::to_string(values.size()) + "]"},
         values.emplace_back());
}

/// Reads keyword arguments into a definition.
template <class D>
void read_members(D& def, const nb::dict& given, const std::string& owner) {
  std::vector<std::string> known;
  for_each_member(def, [&](const char* key, auto& value, const FieldRule& rule, const char*, const char*) {
    known.push_back(key);
    if (given.contains(key))
      read(given[key], {owner, key}, value);
    else if (is_needed(value, rule))
      throw nb::type_error((owner + "() needs the argument " + key).c_str());
  });
  for (const auto& [key, ignored] : given) {
    const std::string name = nb::cast<std::string>(key);
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse_key(owner, name, known);
  }
}

/// An object of the class, a dict of its arguments, or for a Pose a position alone.
template <class T>
requires HasFields<T>
void read(nb::handle given, const Place& place, T& value) {
  if (nb::isinstance<T>(given)) return void(value = nb::cast<T>(given));
  T fresh{};
  if (nb::isinstance<nb::dict>(given)) {
    read_members(fresh, nb::borrow<nb::dict>(given), place.owner + "(): " + place.member);
  } else {
    if constexpr (std::is_same_v<T, Pose>)
      read(given, place, fresh.position);
    else
      refuse(place, "a " + std::string(type_name<T>()) + " or a dict", given);
  }
  value = std::move(fresh);
}

struct ChoiceFromPython {
  nb::handle given;
  std::string allowed{};
  bool found = false;

  template <class T, class Whole>
  void choice(const char*, const T&, Whole& whole, const char*) {
    allowed += (allowed.empty() ? "" : ", ") + std::string(type_name<T>());
    if (found || !nb::isinstance<T>(given)) return;
    whole = nb::cast<T>(given);
    found = true;
  }
};

template <class T>
requires HasChoices<T>
void read(nb::handle given, const Place& place, T& value) {
  ChoiceFromPython choice{given};
  choices(choice, value);
  if (!choice.found) refuse(place, "one of " + choice.allowed, given);
}

}  // namespace meniscus::python
