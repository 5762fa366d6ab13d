// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The interface by which parts list what they carry from one call to the next.
#pragma once

#include <meniscus/types.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// The form of an item's elements: its word in files, and their size in bytes.
struct ElementForm {
  const char* word;
  uint32_t bytes;
};

/// "record" is a struct with a layout of its own.
template <class T>
constexpr ElementForm form_of() {
  static_assert(std::is_trivially_copyable_v<T>);
  const char* word = "record";
  if (std::same_as<T, float>) word = "f32";
  if (std::same_as<T, double>) word = "f64";
  if (std::same_as<T, Vec3>) word = "f32x3";
  if (std::same_as<T, Vec4>) word = "f32x4";
  if (std::same_as<T, int32_t>) word = "i32";
  if (std::same_as<T, uint32_t>) word = "u32";
  if (std::same_as<T, uint64_t>) word = "u64";
  if (std::same_as<T, int64_t>) word = "i64";
  if (std::same_as<T, bool> || std::same_as<T, uint8_t>) word = "u8";
  return {word, sizeof(T)};
}

/// Visits the state of a world's parts: what a step reads that the definitions, the models and the calls of
/// this step do not give. Each part lists its items in one member function, visit_state(StateVisitor&). The
/// same list saves and restores, so an item cannot be in one and not in the other. What a part makes anew in
/// each substep, and what follows from a model, is no state.
///
/// A part that is restored has the same model as the one that was saved, and room for as many particles.
class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  /// Whether the visit changes the parts.
  virtual bool restores() const = 0;

  /// Visits a part. Its items have the part's name before their own.
  template <class Part>
  void part(const std::string& name, Part& part) {
    group(name, [&] { part.visit_state(*this); });
  }
  /// Items that have this name before their own.
  template <class Visit>
  void group(const std::string& name, const Visit& visit) {
    const std::size_t before = path_.size();
    path_ += name;
    path_ += '/';
    visit();
    path_.resize(before);
  }

  /// Whether the visit restores a state of a time when there was no such item. The part then makes it.
  bool lacks(const char* name) const { return restores() && !has(path_ + name); }

  /// A single value on the host.
  template <class T>
  void value(const char* name, T& value) {
    visit_host(named(name), form_of<T>(), &value, 1);
  }
  /// A list on the host whose length is state as well.
  template <class T>
  void list(const char* name, std::vector<T>& values) {
    const std::string path = named(name);
    if (restores()) values.resize(count_of(path));
    visit_host(path, form_of<T>(), values.data(), values.size());
  }
  void text(const char* name, std::string& text) {
    const std::string path = named(name);
    if (restores()) text.resize(count_of(path));
    visit_host(path, {"text", 1}, text.data(), text.size());
  }
  /// An array on the host whose length follows from the model. One that was saved empty restores as zeros.
  template <class T>
  void values(const char* name, std::span<T> values) {
    const std::string path = named(name);
    if (restores() && !values.empty() && count_of(path) == 0) return clear(values);
    visit_host(path, form_of<T>(), values.data(), values.size());
  }
  /// The first `count` elements of an array on the device. A restored array has as many elements as the saved
  /// one; `room` is how many there may be.
  template <class T>
  void array(const char* name, View<T> room, std::size_t count) {
    visit_device(named(name), form_of<T>(), room.data, room.count, count);
  }

 protected:
  /// Saves `count` elements on the host, or restores them.
  virtual void visit_host(const std::string& path, const ElementForm& form, void* data,
                          std::size_t count) = 0;
  virtual void visit_device(const std::string& path, const ElementForm& form, void* data, std::size_t room,
                            std::size_t count) = 0;
  /// The number of elements of the saved item that comes next. Only while restoring.
  virtual std::size_t count_of(const std::string& path) = 0;
  /// Whether an item was saved. Only while restoring.
  virtual bool has(const std::string& path) const = 0;

 private:
  std::string named(const char* name) const { return path_ + name; }
  template <class T>
  static void clear(std::span<T> values) {
    for (T& value : values) value = T{};
  }

  std::string path_;
};

}  // namespace meniscus::pbd
