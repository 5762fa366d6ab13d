// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where vertices of cloth and ropes stick to solids, from one substep to the next.
#pragma once

#include "collision/body/body_set.h"
#include "pbd/restorable_buffer.h"

namespace meniscus::collision {

/// Where a vertex sticks to a solid.
struct StickAnchor {
  Vec3 at;         ///< m, in the body's principal frame; of fixed solids in the world's
  float reach;     ///< m, the slip that it may keep
  uint32_t solid;  ///< see Contact; no_index where the contact has no anchor
  uint32_t body;   ///< likewise
};

/// Lists of anchors by vertex, one after the other. Vertex v has those from start[v] to start[v + 1] − 1.
struct StickLists {
  pbd::View<const StickAnchor> anchors;
  pbd::View<const uint32_t> start;
};

/// Lets friction take back what earlier substeps have left of a slip.
///
/// Friction takes back the slip of its substep (ContactSet). What the solve leaves of that would otherwise be
/// lost, and cloth that is pulled without end would creep by it in each substep. So a contact keeps an
/// anchor: the point of the solid where the vertex has stuck to it. The slip is measured from there:
///
///   slip = tangential part of (x − anchor)
///
/// While |λ_t| < μ λ_n the contact sticks, and the slip that is kept may grow. At the limit it may not: the
/// anchor goes along, as in the return mapping of plasticity. An unloaded contact forgets its anchor.
///
/// The anchor enters through the contact's surface motion, which then is the one since the vertex stuck.
template <class D>
class StickAnchors final : public pbd::ConstraintSet<D> {
 public:
  StickAnchors(D& device, const BodySet<D>& bodies) : device_(device), bodies_(bodies) {}

  /// Sets the number of vertices of all cloth and ropes, which begin without anchors.
  void set_vertices(uint32_t count);

  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>&, int) override {}
  void end(pbd::Substep<D>& substep) override;
  void save() override;
  void restore() override;
  void visit_state(pbd::StateVisitor& v);
  void keep_world(uint32_t each) override;
  void reset_worlds(const pbd::ChosenWorlds& worlds) override;
  void undo_worlds(const pbd::ChosenWorlds& worlds) override;
  /// Visits one world of a batch as visit_state() would visit it alone.
  void visit_world(pbd::StateVisitor& v, uint32_t world);

 private:
  void replace(const pbd::ChosenWorlds& chosen, const StickLists& by);
  StickLists present() { return {anchors_.current(), start_.current()}; }

  D& device_;
  const BodySet<D>& bodies_;
  uint32_t vertices_ = 0;
  pbd::RestorableBuffer<StickAnchor> anchors_{device_, "stick anchors"};
  /// By vertex, where its anchors begin; the total comes last.
  pbd::RestorableBuffer<uint32_t> start_{device_, "stick anchor offsets"};

  // Of a batch: the lists to which worlds are reset.
  bool in_batch_ = false;
  uint32_t kept_vertices_ = 0, kept_count_ = 0;
  pbd::Buffer<StickAnchor> kept_anchors_{device_, "kept stick anchors"};
  pbd::Buffer<uint32_t> kept_start_{device_, "kept stick anchors"};
  pbd::Buffer<uint32_t> lengths_{device_, "stick anchors"};
};

}  // namespace meniscus::collision
