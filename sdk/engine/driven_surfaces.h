// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Moves the vertices of driven surfaces as their tracks say.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "collision/rigid/rigid_world.h"
#include "pbd/device/buffer.h"
#include "pbd/substep.h"
#include "sdk/engine/vertex_track.h"

namespace meniscus {

namespace driven_kernels {

using pbd::Vec4;
using pbd::View;

/// x = a + f (b − a), v = (x − x₀)/h, with x₀ at the substep's start. From now on the accumulated delta of
/// the vertex is the impulse that it withstands (see recorded_part).
struct Place {
  View<const Vec3> from, to;  ///< frames before and after the substep's end
  float fraction;
  uint32_t first;  ///< particle
  View<const Vec4> previous;
  View<Vec4> position, accumulated_delta, velocity;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t i = first + v;
    const Vec3 x = on_way(from[v], to[v], fraction);
    velocity[i] = pbd::with_w(inverse_dt * (x - previous[i].xyz()), velocity[i].w);
    position[i] = pbd::with_w(x, 0);
    accumulated_delta[i] = {0, 0, 0, 0};
  }
};

}  // namespace driven_kernels

/// A driven vertex has w = 0, as one that the world holds. Before contacts are found it is put where its
/// track has it at the substep's end. All else meets it as any vertex.
template <class D>
class DrivenSurfaces final : public pbd::ConstraintSet<D> {
 public:
  /// The time is that of the rigid world.
  DrivenSurfaces(D& device, const collision::RigidWorld& rigid) : device_(device), rigid_(rigid) {}

  void set(std::span<const DrivenPiece> pieces) {
    std::vector<Vec3> all;
    std::vector<Piece> made;
    for (const DrivenPiece& piece : pieces) {
      made.push_back({piece, static_cast<uint32_t>(all.size()), speeds_of(*piece.track)});
      all.insert(all.end(), piece.track->positions.begin(), piece.track->positions.end());
    }
    device_.wait();
    frames_.resize_discard(all.size());
    frames_.write(all);
    pieces_ = std::move(made);
  }

  float speed(float dt) override {
    float most = 0;
    for (const Piece& piece : pieces_) most = std::max(most, piece.speed(rigid_.time(), dt));
    return most;
  }
  void start_step() override {
    start_time_ = rigid_.time();
    passed_ = 0;
  }
  void predict(float dt) override { passed_ += double{dt}; }
  void arrange(pbd::Substep<D>& s) override {
    for (const Piece& piece : pieces_) {
      const TrackPlace at = place_at(*piece.driven.track, start_time_ + passed_);
      const uint32_t vertices = piece.driven.track->vertices();
      const pbd::View<const Vec3> all = frames_.view();
      const pbd::ParticleView& p = s.particles;
      device_.parallel_for("driven/place", vertices,
                           driven_kernels::Place{all.from(piece.first_position + at.frame * vertices),
                                                 all.from(piece.first_position + at.next * vertices),
                                                 at.fraction, p.sorted + piece.driven.first, p.previous,
                                                 p.position, p.accumulated_delta, p.velocity, 1 / s.dt});
    }
  }
  void project(pbd::Substep<D>&, int) override {}

 private:
  struct Piece {
    DrivenPiece driven;
    uint32_t first_position;    // in frames_
    std::vector<float> speeds;  // m/s, by frame

    /// m/s, the greatest from `time` on for dt.
    float speed(double time, float dt) const {
      const uint32_t first = place_at(*driven.track, time).frame;
      const uint32_t last = place_at(*driven.track, time + double{dt}).frame;
      const bool goes_round = driven.track->loop && (last < first || dt >= length());
      const auto begin = speeds.begin() + (goes_round ? 0 : first);
      return *std::max_element(begin, goes_round ? speeds.end() : speeds.begin() + last + 1);
    }
    double length() const { return driven.track->times.back() - driven.track->times.front(); }
  };

  D& device_;
  const collision::RigidWorld& rigid_;
  std::vector<Piece> pieces_;
  double start_time_ = 0, passed_ = 0;  // s
  pbd::Buffer<Vec3> frames_{device_, "frames of driven surfaces"};
};

}  // namespace meniscus
