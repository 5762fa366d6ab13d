// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "collision/body_set.h"

namespace meniscus::collision {

/// A vertex that is held at a point of a body.
struct BodyTie {
  uint32_t vertex;
  uint32_t body;  ///< by its number in the rigid world
  Vec3 anchor;    ///< m, in the body's principal frame: that of RigidMotion::start
};

/// Ties vertices to bodies. A tie is a contact that holds in all directions (pbd::is_tie): the vertex is
/// drawn to its anchor, C = x − anchor = 0, and the body to the vertex, each as its mass allows. What moves a
/// body by its contacts (BodySet) moves it by its ties as well. Where nothing moves the body, the vertex is
/// put in its place at once, and has w = 0 for all constraints: what pulls on it knows that it will not come.
///
/// Must be the first source of contacts, so that a vertex's ties come before its touches, and of the sets
/// before those that move vertices.
template <class D>
class BodyTies final : public pbd::ContactSource<D>, public pbd::ConstraintSet<D>, public pbd::Observer<D> {
 public:
  BodyTies(D& device, const BodySet<D>& bodies) : device_(device), bodies_(bodies), release_(*this) {}

  /// Comes after what settles where vertices are: until then those on bodies that nothing moves have w = 0.
  pbd::ConstraintSet<D>& release() { return release_; }

  /// All there are. Bodies that are gone must have no ties.
  void set_ties(std::span<const BodyTie> ties);
  /// By vertex: a body that it is tied to, or no_index; for ShapeContacts. Valid until ties are set anew.
  pbd::View<const uint32_t> tied_bodies() const { return tied_body_.view(); }
  /// By tie: what it gave to its vertex in the last step, N·s. The body got the opposite.
  std::vector<Vec3> read_impulses() const;

  bool any() const override { return ties_.size() > 0; }
  bool any_moving() const override { return any(); }
  void count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) override;
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;
  void start_step() override { impulse_.fill(0); }
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>&, int) override {}
  void observe(const pbd::Substep<D>& substep) override;

 private:
  struct Release final : pbd::ConstraintSet<D> {
    explicit Release(BodyTies& owner) : ties(owner) {}
    void project(pbd::Substep<D>&, int) override {}
    void settle(pbd::Substep<D>& substep) override { ties.let_go(substep); }
    BodyTies& ties;
  };
  void let_go(pbd::Substep<D>& substep);

  D& device_;
  const BodySet<D>& bodies_;
  Release release_;
  std::vector<uint32_t> place_;  // of each tie among those in the order of their vertices
  pbd::Buffer<BodyTie> ties_{device_, "ties"};
  pbd::Buffer<pbd::Vec4> impulse_{device_, "tie impulses"};
  pbd::Buffer<pbd::Vec4> held_{device_, "held ties"};  // by tie, m: the way of its vertex; w: its own
  pbd::Buffer<uint32_t> tied_body_{device_, "tied bodies"};
};

}  // namespace meniscus::collision
