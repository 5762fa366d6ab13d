// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "collision/body/body_set.h"

namespace meniscus::collision {

/// A vertex that is held at a point of a body.
struct BodyAttachment {
  uint32_t vertex;
  uint32_t body;  ///< by its number in the rigid world
  Vec3 anchor;    ///< m, in the body's principal frame: that of RigidMotion::start
};

namespace attachment_kernels {
struct JoinedAttachments;
}

/// Attaches vertices to bodies. An attachment is a contact that holds in all directions (pbd::is_attachment),
/// C = x − anchor = 0, and half of a body is split among its attachments (mass splitting, as for contacts:
/// BodySet). While constraints are solved, a attached vertex weighs as much as it and its share of the body
/// together,
///
///   1/w = 1/w_v + 1/w_b,  w_b = 2 n k,
///
/// with n attachments of the body, which give way by k, 1/kg, in the softest direction of K = 1/M + [r]ᵀ I⁻¹
/// [r]. So a constraint that pulls on the vertex pulls on the body, whose mass may be thousands of times the
/// vertex's own: by its own w it would come along freely, and pull the body by next to nothing in each
/// iteration. What the vertex has been moved by, d, its share of the body was as well: λ = d/w_b. All that
/// the body gets moves it, and the anchors with it (BodySet). Where they did not follow their vertices, the
/// next iteration starts with C = 0, which brings both together, each by its own mass: Δλ = −(w_v + 2 n K)⁻¹
/// C. Constraints must see what comes of that: if both corrected the same error at once, light vertices would
/// overshoot.
///
/// Where nothing moves the body, the vertex is put in its place at once, and has w = 0.
///
/// Must be the first source of contacts, so that a vertex's attachments come before its touches, and of the
/// sets before those that move vertices.
template <class D>
class BodyAttachments final : public pbd::ContactSource<D>,
                              public pbd::ConstraintSet<D>,
                              public pbd::Observer<D> {
 public:
  BodyAttachments(D& device, const BodySet<D>& bodies) : device_(device), bodies_(bodies), release_(*this) {}

  /// Comes after what moves vertices, and settles where they are: until then they weigh what they are
  /// attached to.
  pbd::ConstraintSet<D>& release() { return release_; }

  /// All there are. Bodies that are gone must have no attachments.
  void set_attachments(std::span<const BodyAttachment> attachments);
  /// By vertex: a body that it is attached to, or no_index; for ShapeContacts. Valid until attachments are
  /// set anew.
  pbd::View<const uint32_t> attached_bodies() const { return attached_body_.view(); }
  /// By attachment: what it gave to its vertex in the last step, N·s. The body got the opposite.
  std::vector<Vec3> read_impulses() const;

  bool any() const override { return attachments_.size() > 0; }
  bool any_moving() const override { return any(); }
  void count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) override;
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;
  void start_step() override { impulse_.fill(0); }
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void observe(const pbd::Substep<D>& substep) override;

 private:
  struct Release final : pbd::ConstraintSet<D> {
    explicit Release(BodyAttachments& owner) : attachments(owner) {}
    void project(pbd::Substep<D>& substep, int) override { attachments.hand_on(substep); }
    void settle(pbd::Substep<D>& substep) override { attachments.let_go(substep); }
    BodyAttachments& attachments;
  };
  void hand_on(pbd::Substep<D>& substep);
  void let_go(pbd::Substep<D>& substep);
  attachment_kernels::JoinedAttachments joined(const pbd::Substep<D>& substep);

  D& device_;
  const BodySet<D>& bodies_;
  Release release_;
  std::vector<uint32_t> place_;  // of each attachment among those in the order of their vertices
  pbd::Buffer<BodyAttachment> attachments_{device_, "attachments"};
  pbd::Buffer<pbd::Vec4> impulse_{device_, "attachment impulses"};
  pbd::Buffer<pbd::Vec4> joined_{device_, "attached vertices"};  // see attachment_kernels::JoinedAttachments
  pbd::Buffer<uint32_t> attachments_of_body_{device_, "attachments of bodies"};
  pbd::Buffer<uint32_t> attached_body_{device_, "attached bodies"};
};

}  // namespace meniscus::collision
