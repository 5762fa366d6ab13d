// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds out whether a new particle has room at a place.
#pragma once

#include <algorithm>
#include <vector>

#include "pbd/device/buffer.h"
#include "sdk/engine/engine.h"
#include "sdk/engine/free_room_kernels.h"
#include "sdk/engine/tuning.h"

namespace meniscus {

/// Finds out whether arrivals have room.
template <class D>
class FreeRoom {
 public:
  FreeRoom(D& device, float spacing, float contact_radius)
      : device_(device), spacing_(spacing), contact_radius_(contact_radius) {}

  /// Reserves memory for this many arrivals. Grows by more than needed.
  void reserve(uint32_t count) {
    if (count > arrivals_.size()) {
      const uint32_t room = std::max(64u, count + count / 2);
      arrivals_.resize_or_stay(room);
      number_.resize_or_stay(room);
      blocked_.resize_or_stay(room);
    }
    const size_t buckets = PointTable::buckets_for(count) + 1;
    if (buckets > start_.size()) start_.resize_or_stay(buckets);
  }

  /// Sets has_room[i] to whether arrivals[i] has room beside all particles, and beside earlier arrivals with
  /// room. merge(blocked) may add what particles elsewhere block: not 0.
  template <class Merge>
  void find(pbd::Particles& particles, const collision::ShapeSet& shapes, std::span<const Arrival> arrivals,
            std::vector<uint8_t>& has_room, const Merge& merge) {
    const auto count = static_cast<uint32_t>(arrivals.size());
    reserve(count);
    fill_table(arrivals);
    arrivals_.write(arrivals);
    start_.write(table_.start());
    number_.write(table_.number());
    blocked_.fill(0);
    const pbd::View<const Arrival> view = arrivals_.view().first(count);
    const uint32_t starts = static_cast<uint32_t>(table_.start().size());
    device_.parallel_for(
        "emitters/particles", particles.count(),
        free_room_kernels::BlockByParticles{particles.position.current.view(),
                                            particles.velocity.current.view(),
                                            particles.phase.current.view(),
                                            particles.sorted(),
                                            view,
                                            {start_.view().first(starts), number_.view(), apart()},
                                            box_,
                                            blocked_.view(),
                                            apart()});
    device_.parallel_for("emitters/solids", count,
                         free_room_kernels::BlockBySolids{shapes, view, blocked_.view(), clearance(),
                                                          spacing_, contact_radius_});
    seen_.resize(count);
    blocked_.read(std::span(seen_));
    merge(std::span(seen_));
    choose(arrivals, has_room);
  }

 private:
  float apart() const { return engine_tuning::apart * spacing_; }
  float clearance() const { return engine_tuning::clearance * spacing_; }

  void fill_table(std::span<const Arrival> arrivals) {
    points_.clear();
    for (const Arrival& a : arrivals) points_.push_back(a.to);
    table_.fill(points_, apart());
    box_ = {points_.front(), points_.front()};
    for (Vec3 p : points_) box_ = {min(box_.lower, p), max(box_.upper, p)};
    const Vec3 margin{apart(), apart(), apart()};
    box_ = {box_.lower - margin, box_.upper + margin};
  }

  void choose(std::span<const Arrival> arrivals, std::vector<uint8_t>& has_room) const {
    has_room.assign(arrivals.size(), 0);
    for (uint32_t i = 0; i < arrivals.size(); ++i) {
      bool near = false;
      table_.view().for_each_near(
          points_[i], free_room_kernels::FindEarlier{points_.data(), has_room.data(), i, apart(), near});
      has_room[i] = seen_[i] == 0 && !near;
    }
  }

  D& device_;
  float spacing_, contact_radius_;
  std::vector<Vec3> points_;
  std::vector<uint32_t> seen_;
  PointTable table_;
  Aabb box_{};
  pbd::Buffer<Arrival> arrivals_{device_, "arrivals"};
  pbd::Buffer<uint32_t> start_{device_, "arrivals by cell"};
  pbd::Buffer<uint32_t> number_{device_, "arrivals by cell"};
  pbd::Buffer<uint32_t> blocked_{device_, "blocked arrivals"};
};

}  // namespace meniscus
