// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Constraints of a user's own, solved by XPBD within the iterations of the solver. Include it in a .cpp for
// worlds on the CPU, or in a .cu that nvcc compiles for both devices (C++20, no relocatable device code).
#pragma once

#include <meniscus/device/memory.h>
#include <meniscus/device/xpbd.h>
#include <meniscus/world.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meniscus {

/// Colours constraints so that no two of a colour share a point: each gets the first free colour, in order.
/// Throws Error(capacity) if a point has more than 64 constraints.
template <class Constraint>
std::vector<uint32_t> colours_of(const std::vector<Constraint>& constraints) {
  std::unordered_map<uint32_t, uint64_t> taken;
  std::vector<uint32_t> colours;
  for (const Constraint& constraint : constraints) {
    uint64_t used = 0;
    for (const uint32_t point : constraint.points) used |= taken[point];
    uint32_t colour = 0;
    while (colour < 64 && (used >> colour & 1)) ++colour;
    if (colour == 64) throw Error(ErrorCode::capacity, "a point has more than 64 constraints");
    for (const uint32_t point : constraint.points) taken[point] |= uint64_t{1} << colour;
    colours.push_back(colour);
  }
  return colours;
}

/// The constraints of one kind in one world. `Constraint` is a plain struct with
///
///   static constexpr uint32_t point_count = 2;
///   uint32_t points[point_count];  // indices in World::ids(), or 2³¹ + the number of a vertex
///   float compliance;              // m/N, ≥ 0
///   MENISCUS_BOTH_DEVICES float value(const Vec3 (&x)[point_count], Vec3 (&gradient)[point_count]) const;
///
/// value() returns C and fills in ∇C by point. The constraints add calls to the hooks contacts_found and
/// iterated of the world. Several kinds run in the order in which they were made. Constraints of one colour
/// run at once; colours run in order, so that results repeat bit for bit. After particles were removed,
/// indices in World::ids() are others: make the constraints anew.
template <class Constraint>
class ConstraintsOf {
 public:
  /// Throws Error(invalid_argument) for an index that no particle has, and Error(capacity).
  ConstraintsOf(World& world, std::vector<Constraint> constraints)
      : shared_(std::make_shared<Shared>()), world_(&world) {
    const std::size_t particles = world.particle_count();
    for (const Constraint& constraint : constraints) {
      for (const uint32_t point : constraint.points) {
        if (point < device::first_vertex && point >= particles)
          throw Error(ErrorCode::invalid_argument, "a constraint has the point " + std::to_string(point) +
                                                       ", and the world has " + std::to_string(particles) +
                                                       " particles");
      }
    }
    sort_by_colour(constraints);
    begin_ = world.add_hook(Hook::contacts_found,
                            [shared = shared_](const SubstepView& view) { shared->begin(view); });
    try {
      project_ = world.add_hook(Hook::iterated,
                                [shared = shared_](const SubstepView& view) { shared->project(view); });
    } catch (...) {
      world.remove_hook(begin_);
      throw;
    }
  }
  /// Removes them from the world, which must still be there.
  void remove() {
    world_->remove_hook(begin_);
    world_->remove_hook(project_);
  }
  /// The number of colours.
  std::size_t colour_count() const { return shared_->colour_starts.size() - 1; }

 private:
  struct Shared {
    std::vector<Constraint> constraints;     // by colour
    std::vector<uint32_t> colour_starts{0};  // with the number of all at the end
    device::Array<Constraint> on_device;
    device::Array<float> multipliers;
    device::Array<uint32_t> place;

    void begin(const SubstepView& view) {
      const auto count = static_cast<uint32_t>(constraints.size());
      if (on_device.size() != count) on_device.write(view.on_cuda, view.stream, constraints);
      multipliers.resize(view.on_cuda, count);
      place.resize(view.on_cuda, view.particles);
      device::for_each(view.on_cuda, view.stream, view.particles,
                       device::FindPlaces{view.slots, place.data()});
      device::for_each(view.on_cuda, view.stream, count, device::Clear{multipliers.data()});
    }
    void project(const SubstepView& view) {
      const device::XpbdArrays arrays{view.positions, view.corrections, place.data(), view.particles,
                                      1 / (view.dt * view.dt)};
      for (std::size_t colour = 0; colour + 1 < colour_starts.size(); ++colour) {
        const uint32_t first = colour_starts[colour], count = colour_starts[colour + 1] - first;
        device::for_each(
            view.on_cuda, view.stream, count,
            device::Project<Constraint>{on_device.data() + first, multipliers.data() + first, arrays});
      }
    }
  };

  void sort_by_colour(const std::vector<Constraint>& constraints) {
    const std::vector<uint32_t> colours = colours_of(constraints);
    std::vector<std::size_t> order(constraints.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return colours[a] < colours[b]; });
    for (const std::size_t k : order) {
      while (shared_->colour_starts.size() <= colours[k])
        shared_->colour_starts.push_back(static_cast<uint32_t>(shared_->constraints.size()));
      shared_->constraints.push_back(constraints[k]);
    }
    shared_->colour_starts.push_back(static_cast<uint32_t>(shared_->constraints.size()));
  }

  std::shared_ptr<Shared> shared_;
  World* world_;
  HookId begin_{}, project_{};
};

}  // namespace meniscus
