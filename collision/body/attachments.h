// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Attachments of vertices to rigid bodies, as a source of contacts and a constraint set.
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
/// C = x − anchor = 0. Half of a body is split among its attachments (mass splitting, as for contacts:
/// BodySet). While constraints are solved, an attached vertex has the mass of itself and of its fraction of
/// the body together:
///
///   1/w = 1/w_v + 1/w_b,  w_b = 2 n k,
///
/// where n is the number of attachments of the body. k, in 1/kg, is the inverse mass in the softest direction
/// of K = 1/M + [r]ᵀ I⁻¹ [r]. So a constraint that pulls on the vertex pulls on the body, whose mass may be
/// thousands of times the vertex's. With its own w the vertex would follow any pull, and would pull the body
/// by next to nothing in each iteration.
///
/// A displacement d of the vertex displaces its fraction of the body as well: λ = d/w_b. All that the body
/// gets moves it, and the anchors with it (BodySet). Where anchors did not follow their vertices, the next
/// iteration starts by solving C = 0 with the mass of each: Δλ = −(w_v + 2 n K)⁻¹ C. Constraints must see the
/// result. If both corrected the same error at once, light vertices would overshoot.
///
/// A vertex that is attached to an immovable body is at its anchor before contacts are found, moves as the
/// anchor does, and has w = 0. Like any held particle, it records the impulses that it withstands.
///
/// Must be the first source of contacts, so that a vertex's attachments come before its other contacts. Among
/// the constraint sets it must come before those that move vertices.
template <class D>
class BodyAttachments final : public pbd::ContactSource<D>,
                              public pbd::ConstraintSet<D>,
                              public pbd::Observer<D> {
 public:
  BodyAttachments(D& device, const BodySet<D>& bodies) : device_(device), bodies_(bodies), release_(*this) {}

  /// Must come after the sets that move vertices, and settles their positions. Until then a vertex has the
  /// mass of what it is attached to.
  pbd::ConstraintSet<D>& release() { return release_; }

  /// Sets all attachments. A body that is gone must have none.
  void set_attachments(std::span<const BodyAttachment> attachments);
  /// For ShapeContacts. Valid until the next set_attachments().
  AttachedBodies attached_bodies() const { return {attached_start_.view(), attached_body_.view()}; }
  /// By attachment: the impulse on its vertex in the last step, N·s. The body got the opposite.
  std::vector<Vec3> read_impulses() const;

  bool any() const override { return attachments_.size() > 0; }
  bool any_moving() const override { return any(); }
  void count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) override;
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;
  void start_step() override {
    impulse_.fill(0);
    holds_ = false;  // a step may have failed before begin()
  }
  void arrange(pbd::Substep<D>& substep) override;
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void observe(const pbd::Substep<D>& substep) override;

 private:
  struct Release final : pbd::ConstraintSet<D> {
    explicit Release(BodyAttachments& owner) : attachments(owner) {}
    void project(pbd::Substep<D>& substep, int) override { attachments.transfer_push(substep); }
    void settle(pbd::Substep<D>& substep) override { attachments.release_vertices(substep); }
    BodyAttachments& attachments;
  };
  void hold(pbd::Substep<D>& substep);
  void transfer_push(pbd::Substep<D>& substep);
  void release_vertices(pbd::Substep<D>& substep);
  attachment_kernels::JoinedAttachments joined(const pbd::Substep<D>& substep);

  D& device_;
  const BodySet<D>& bodies_;
  Release release_;
  bool holds_ = false;           // whether vertices are held since arrange()
  std::vector<uint32_t> place_;  // of each attachment: its index in the order of vertices
  pbd::Buffer<BodyAttachment> attachments_{device_, "attachments"};
  pbd::Buffer<pbd::Vec4> impulse_{device_, "attachment impulses"};
  pbd::Buffer<pbd::Vec4> joined_{device_, "attached vertices"};  // see attachment_kernels::JoinedAttachments
  pbd::Buffer<uint32_t> attachments_of_body_{device_, "attachments of bodies"};
  pbd::Buffer<uint32_t> attached_start_{device_, "attached bodies"};
  pbd::Buffer<uint32_t> attached_body_{device_, "attached bodies"};
};

}  // namespace meniscus::collision
