// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A table of values by id; refuses ids that are stale or of another world.
#pragma once

#include <meniscus/error.h>
#include <meniscus/ids.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sdk/world/check/world_number.h"

namespace meniscus {

/// Things by id. A place is used again with a new generation, so that an id of something destroyed is
/// refused. A place whose generations are used up is used no more.
template <class IdType, class T>
class IdTable {
 public:
  /// Generations count from `first_generation` on, and stay below the next world's (see WorldNumber).
  IdTable(const char* what, uint32_t first_generation) : what_(what), first_generation_(first_generation) {}

  /// Takes the memory that the next insert() needs, which then cannot fail. Returns the index that it takes.
  uint32_t prepare() {
    if (entries_.size() == entries_.capacity()) entries_.reserve(2 * entries_.size() + 1);
    while (first_free_ < entries_.size() && (entries_[first_free_].value || is_used_up(first_free_)))
      ++first_free_;
    return first_free_;
  }

  IdType insert(T value) {
    uint32_t index = first_free_;
    while (index < entries_.size() && (entries_[index].value || is_used_up(index))) ++index;
    if (index == entries_.size()) entries_.push_back({std::nullopt, first_generation_});
    entries_[index].value = std::move(value);
    first_free_ = index + 1;
    ++size_;
    return {index, entries_[index].generation};
  }

  void erase(IdType id) {
    get(id);
    entries_[id.index].value.reset();
    first_free_ = std::min(first_free_, id.index);
    --size_;
    ++entries_[id.index].generation;
  }

  uint32_t size() const { return size_; }

  /// Drops all entries and places.
  void clear() {
    entries_.clear();
    first_free_ = size_ = 0;
  }

  /// nullptr where there is none.
  const T* find(IdType id) const {
    if (id.index >= entries_.size() || entries_[id.index].generation != id.generation) return nullptr;
    return entries_[id.index].value ? &*entries_[id.index].value : nullptr;
  }

  const T& get(IdType id) const {
    if (const T* value = find(id)) return *value;
    if (id == IdType{})
      throw Error(ErrorCode::not_found, std::string("no ") + what_ + " is meant: the id is not set");
    throw Error(ErrorCode::not_found, std::string("no ") + what_ + " has the index " +
                                          std::to_string(id.index) + " and the generation " +
                                          std::to_string(id.generation) + " in this world");
  }

  T& edit(IdType id) { return const_cast<T&>(get(id)); }

  /// Of what stands at an index, where something does.
  IdType id(uint32_t index) const { return {index, entries_[index].generation}; }

  /// Of all places, used or not, how often each was freed.
  std::vector<uint32_t> generations() const {
    std::vector<uint32_t> all;
    for (const Entry& entry : entries_) all.push_back(entry.generation - first_generation_);
    return all;
  }
  /// Empty places of these generations, for a table that is empty.
  void set_generations(const std::vector<uint32_t>& generations) {
    clear();
    for (const uint32_t g : generations) entries_.push_back({std::nullopt, first_generation_ + g});
  }
  /// Fills an empty place.
  void put(uint32_t index, T value) {
    entries_[index].value = std::move(value);
    ++size_;
  }

  /// All ids, in the order of the indices.
  std::vector<IdType> ids() const {
    std::vector<IdType> all;
    for_each([&](uint32_t index, const T&) { all.push_back(id(index)); });
    return all;
  }

  /// The first for whose value `suits` holds.
  template <class Suits>
  std::optional<IdType> find_first(const Suits& suits) const {
    for (uint32_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].value && suits(*entries_[i].value)) return id(i);
    }
    return std::nullopt;
  }

  const char* what() const { return what_; }

  /// Calls visit(index, value) for each, in the order of the indices.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (uint32_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].value) visit(i, *entries_[i].value);
    }
  }
  template <class Visit>
  void for_each(const Visit& visit) {
    for (uint32_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].value) visit(i, *entries_[i].value);
    }
  }

 private:
  bool is_used_up(uint32_t index) const {
    return entries_[index].generation - first_generation_ == generations_of_a_world - 1;
  }

  struct Entry {
    std::optional<T> value;
    uint32_t generation;
  };

  const char* what_;
  uint32_t first_generation_;
  uint32_t first_free_ = 0;  // below it all places are taken
  uint32_t size_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace meniscus
