// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Parts particles that were created at one point, or far too dense.
#pragma once

#include <utility>

#include "fluid/density/crowd_kernels.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/gather.h"
#include "pbd/substep.h"

namespace meniscus::fluid {

/// A crowd is what was placed far above the rest density, and what it compresses. Its compression is
/// inherited: no motion made it. So the density constraint must not turn it into speed. A crowd
///   - keeps its compression in the density constraint, which resists only what would increase it;
///   - is parted by displacements that give no speed, pair by pair, equal and opposite:
///       Δx_i = w_i Σ_j min(β_i + β_j, b_i, b_j) |e_ij| n_ij
///       β_i  = momentum · last β_i + ω E_i / D_i   E_i: C, or the nearness of those at the same point
///       b_i  = limit / (w_i Σ_j |e_ij|)         so |Δx_i| ≤ limit, whatever the neighbours are
///     n_ij is the direction of x_i − x_j, or at one point one that is hashed from the pair's numbers.
///
/// Without a crowd nothing is launched.
template <class D>
class Crowd {
  using Member = crowd_kernels::Member;

 public:
  explicit Crowd(D& device) : device_(device) {
    left_.resize_discard(1);
    left_.host()[0] = 0;
  }

  /// Call it when particles were placed. Only those start a crowd, so that others do not notice.
  void note_placed(uint32_t first, uint32_t count) {
    if (!watching_) make_room();
    placed_ = watching_ = true;
    device_.parallel_for("crowd/placed", count, crowd_kernels::MarkPlaced{first, member_.current.view()});
  }

  // As in ParticleState.
  void reserve(uint32_t size, uint32_t kept) {
    size_ = size;
    if (watching_) {
      member_.reserve(size, kept);
      make_scratch();
    }
  }
  void clear(uint32_t first, uint32_t count) {
    if (count && watching_) device_.fill(member_.current.view().data + first, 0, count * sizeof(Member));
  }
  void reorder(pbd::View<const uint32_t> order, uint32_t count) {
    if (watching_) pbd::gather_in_order(device_, "crowd/reorder", member_, order, count);
  }
  void save() {
    saved_ = {watching_, placed_};
    if (watching_ && size_)
      device_.copy(saved_member_.view().data, member_.current.view().data, size_ * sizeof(Member));
  }
  void restore() {
    if (saved_.watching && size_)
      device_.copy(member_.current.view().data, saved_member_.view().data, size_ * sizeof(Member));
    watching_ = saved_.watching;
    placed_ = saved_.placed;
    is_restored_ = true;
  }
  void visit_state(pbd::StateVisitor& v) {
    v.value("watching", watching_);
    v.value("placed", placed_);
    v.values("left", left_.host());
    is_restored_ = false;
    if (!watching_) return;
    if (v.restores()) make_room();
    v.array("member", member_.current.view(), member_.current.size());
  }
  /// Whether there may be one in the next step.
  bool any() const { return placed_ || (watching_ && left_.host()[0] > 0); }
  void start_step() {
    if (!std::exchange(is_restored_, false) && !placed_) watching_ = watching_ && left_.host()[0] > 0;
  }

  /// Parts the crowd by at most `limit` (m) in all rounds together. Returns the compression that each
  /// particle may keep in this substep, or nothing where there is no crowd.
  template <class K>
  pbd::View<const float> part(pbd::Substep<D>& substep, const K& kernel, float spacing, float limit) {
    using namespace crowd_kernels;
    if (!watching_) return {};
    const pbd::ParticleView& p = substep.particles;
    const uint32_t fluid = p.sorted;
    const pbd::ContactView contacts = substep.contacts.of_first(fluid);
    const float near = crowd_tuning::near_spacings * spacing;
    device_.parallel_for(
        "crowd/begin", fluid,
        Begin{p.previous, member_.current.view(), position_.view(), in_crowd_.view(), left_.view()});
    refresh_ghost_positions(device_, substep.ghosts, position_.view());
    refresh_ghosts(device_, substep.ghosts, in_crowd_.view());
    const int rounds = substep.iterations;
    for (int round = 0; round < rounds; ++round) {
      device_.parallel_for_long("crowd/survey", fluid,
                                Survey<K>{kernel, near, crowd_tuning::momentum, crowd_tuning::relaxation,
                                          limit / static_cast<float>(rounds), position_.view(), p.phase,
                                          substep.neighbours, contacts, in_crowd_.view(),
                                          next_in_crowd_.view(), member_.current.view(), parting_.view()});
      in_crowd_.swap(next_in_crowd_);
      refresh_ghosts(device_, substep.ghosts, in_crowd_.view());
      refresh_ghosts(device_, substep.ghosts, parting_.view());
      device_.parallel_for_long("crowd/part", fluid,
                                Part{kernel, position_.view(), parting_.view(), p.number, substep.neighbours,
                                     contacts, p.previous, next_position_.view()});
      position_.swap(next_position_);
      refresh_ghost_positions(device_, substep.ghosts, position_.view());
    }
    device_.parallel_for_long("crowd/finish", fluid,
                              Finish<K>{kernel, near, crowd_tuning::recovery * substep.dt, p.previous,
                                        position_.view(), substep.neighbours, contacts, in_crowd_.view(),
                                        p.position, member_.current.view(), allowed_.view(), left_.view()});
    placed_ = false;
    return allowed_.view();
  }

 private:
  void make_room() {
    member_.current.resize_discard(size_);
    member_.next.resize_discard(size_);
    member_.current.fill(0);
    make_scratch();
  }
  /// The sentinel of neighbour lists is far away, outside of the crowd, and has no part in any pair.
  void make_scratch() {
    position_.resize_discard(size_);
    next_position_.resize_discard(size_);
    in_crowd_.resize_discard(size_);
    next_in_crowd_.resize_discard(size_);
    saved_member_.resize_discard(size_);
    allowed_.resize_discard(size_);
    parting_.resize_discard(size_);
    parting_.fill(0);
    in_crowd_.fill(0);
    next_in_crowd_.fill(0);
    if (size_ == 0) return;
    constexpr float away = pbd::Particles::far_away;
    const pbd::Vec4 sentinel[] = {{away, away, away, 0}};
    position_.write(sentinel, size_ - pbd::Particles::padding);
    next_position_.write(sentinel, size_ - pbd::Particles::padding);
  }

  struct Watch {
    bool watching = false;  // there may be a crowd
    bool placed = false;    // particles were placed since the last substep
  };

  D& device_;
  bool watching_ = false, placed_ = false;
  Watch saved_;
  bool is_restored_ = false;  // the step is to be repeated
  uint32_t size_ = 0;

  pbd::DoubleBuffer<Member> member_{device_, "crowd members"};
  pbd::Buffer<Member> saved_member_{device_, "crowd members"};
  pbd::Buffer<float> in_crowd_{device_, "crowd members"}, next_in_crowd_{device_, "crowd members"},
      allowed_{device_, "crowd compression"};
  pbd::Buffer<pbd::Vec4> position_{device_, "crowd positions"}, next_position_{device_, "crowd positions"};
  pbd::Buffer<pbd::Vec4> parting_{device_, "crowd multipliers"};
  pbd::SharedBuffer<uint32_t> left_{device_, "crowd size"};
};

}  // namespace meniscus::fluid
