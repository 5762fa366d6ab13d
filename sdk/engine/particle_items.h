// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The items of an engine's state that have an element for each particle. In a shared world each rank has its
// own part of them.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pbd/device/device.h"
#include "pbd/state/bytes_hash.h"
#include "pbd/state/state_visitor.h"

namespace meniscus {

/// In the order in which they are visited. An item may have room for more elements.
inline constexpr std::array<std::string_view, 6> particle_items{
    "solver/particles/position", "solver/particles/velocity", "solver/particles/phase",
    "solver/particles/slot",     "solver/particles/number",   "density/multiplier"};
/// Items that say how many particles there are.
inline constexpr std::array<std::string_view, 3> particle_counts{"solver/particles/count",
                                                                 "solver/particles/sorted", "sorted_in_step"};

inline bool is_particle_item(std::string_view path) {
  return std::find(particle_items.begin(), particle_items.end(), path) != particle_items.end();
}
inline bool is_particle_count(std::string_view path) {
  return std::find(particle_counts.begin(), particle_counts.end(), path) != particle_counts.end();
}

/// The elements of a rank.
struct ParticleItem {
  uint32_t element_bytes = 0;
  std::vector<std::byte> data;
};

/// Reads the first `count` elements of each item, from an engine.
class ParticleItemReader final : public pbd::StateVisitor {
 public:
  ParticleItemReader(pbd::Device& device, uint32_t count) : device_(device), count_(count) {}
  bool restores() const override { return false; }
  const std::vector<ParticleItem>& items() const { return items_; }

 private:
  void visit_host(const std::string&, const pbd::ElementForm&, void*, std::size_t) override {}
  void visit_device(const std::string& path, const pbd::ElementForm& form, void* data, std::size_t,
                    std::size_t) override {
    if (!is_particle_item(path)) return;
    ParticleItem item{form.bytes, std::vector<std::byte>(std::size_t{form.bytes} * count_)};
    if (count_) device_.copy_out(item.data.data(), data, item.data.size());
    items_.push_back(std::move(item));
  }
  std::size_t count_of(const std::string&) override { return 0; }
  bool has(const std::string&) const override { return false; }

  pbd::Device& device_;
  uint32_t count_;
  std::vector<ParticleItem> items_;
};

}  // namespace meniscus
