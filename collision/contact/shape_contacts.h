// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The source of contacts between particles and shapes, fixed and moving.
#pragma once

#include "collision/contact/candidates.h"
#include "collision/contact/tuning.h"
#include "pbd/substep.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::collision {

/// What a particle collides with, and the contact radius at which its centre stops, m.
struct Touch {
  CollisionFilter filter;
  float radius;
};

/// The bodies that vertices are attached to: those of vertex v are bodies[start[v]] to bodies[start[v + 1] −
/// 1]. Vertices from start.count − 1 on are attached to none.
struct AttachedBodies {
  pbd::View<const uint32_t> start, bodies;

  MENISCUS_HD bool has(uint32_t vertex, uint32_t body) const {
    if (vertex + 1 >= start.count) return false;
    for (uint32_t k = start[vertex]; k < start[vertex + 1]; ++k) {
      if (bodies[k] == body) return true;
    }
    return false;
  }
};

/// The triangles of points of faces, which are the particles from `first` on; see FacePoints.
struct PointTriangles {
  pbd::View<const pbd::SurfaceTriangle> triangles;
  pbd::View<const uint32_t> triangle_of;  ///< by point; no_index where it is not in use
  uint32_t first = 0;
};

namespace shape_contact_kernels {

/// The distance (m) by which an overlapping particle leaves a solid in a substep. If it left at once, it
/// would get the speed of that displacement.
MENISCUS_HD inline float exit_distance(float contact_radius, float dt) {
  return contact_radius * dt / shape_tuning::exit_time;
}

/// How a particle collides with solids, by its fluid or its piece of cloth. A vertex does not collide with
/// the bodies that it is attached to. Nor does a face that it belongs to: the face would always touch them.
struct Touches {
  pbd::View<const pbd::Phase> phase;
  pbd::View<const CollisionFilter> by_fluid;
  pbd::View<const Touch> by_piece;
  float fluid_radius;
  AttachedBodies attached;
  PointTriangles points;
  uint32_t sorted = 0;  ///< see ParticleView

  MENISCUS_HD Touch of(uint32_t i) const {
    if (by_piece.count && is_vertex(i)) return by_piece[pbd::phase_group(phase[i])];
    return {by_fluid.count ? by_fluid[pbd::phase_group(phase[i])] : CollisionFilter{}, fluid_radius};
  }
  MENISCUS_HD bool is_vertex(uint32_t i) const { return (phase[i] & pbd::phase_vertex) != 0; }
  MENISCUS_HD bool is_face(uint32_t i) const { return by_piece.count && (phase[i] & pbd::phase_face) != 0; }
  MENISCUS_HD bool may_overlap(uint32_t i) const { return (phase[i] & pbd::phase_overlapping) != 0; }
  /// Whether i is a point of a face, and in use.
  MENISCUS_HD bool is_used_point(uint32_t i) const {
    return points.triangle_of[i - points.first] != pbd::no_index;
  }
  /// Whether i, or a vertex of its face, is attached to the body.
  MENISCUS_HD bool is_attached(uint32_t i, uint32_t body) const {
    if (body == pbd::no_index || i < sorted || attached.bodies.count == 0) return false;
    return is_face(i) ? is_face_attached(points.triangles[points.triangle_of[i - points.first]], body)
                      : attached.has(i - sorted, body);
  }
  MENISCUS_HD bool is_face_attached(const pbd::SurfaceTriangle& t, uint32_t body) const {
    return attached.has(t.a, body) || attached.has(t.b, body) || attached.has(t.c, body);
  }
};

}  // namespace shape_contact_kernels

/// Finds the contacts of particles with shapes, fixed and moving.
template <class D>
class ShapeContacts final : public pbd::ContactSource<D> {
 public:
  ShapeContacts(D& device, pbd::Particles& particles, float support_radius, float contact_radius)
      : device_(device),
        particles_(particles),
        support_radius_(support_radius),
        contact_radius_(contact_radius),
        largest_radius_(contact_radius),
        candidates_(device),
        filters_(device, "fluid filters"),
        pieces_(device, "cloth surfaces") {}

  /// The views must stay valid until the next call.
  void set_shapes(const ShapeSet& shapes, bool fixed_are_planes);
  /// One filter a fluid.
  void set_filters(std::span<const CollisionFilter> filters);
  /// One filter a fluid, or empty where all collide with everything. Valid until the next set_filters().
  pbd::View<const CollisionFilter> filters() const { return filters_.view(); }
  /// One entry a piece of cloth.
  void set_pieces(std::span<const Touch> pieces);
  /// The views must stay valid until the next call.
  void set_attached_bodies(const AttachedBodies& bodies) { attached_ = bodies; }
  /// The views must stay valid for the substep.
  void set_points(const PointTriangles& points) { points_ = points; }

  void reserve(uint32_t particles) override;
  bool any() const override { return shapes_.shapes.count > 0; }
  bool any_moving() const override { return shapes_.fixed < shapes_.shapes.count; }
  bool any_but_fixed_planes() const { return !only_fixed_planes() && any(); }
  bool limits_motion() const override { return shapes_.fixed > 0 && !fixed_are_planes_; }
  void limit_motion(const pbd::MotionView& motion, bool planes_too) override;
  void count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) override;
  bool counts_all() const override { return any(); }
  void fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) override;

  /// Rolls back motions that have passed through a moving shape since the substep began. Shapes are at their
  /// final poses, and have moved by `furthest` (m) at most. A particle may be carried that far, and meet
  /// another shape there. What is held stays.
  void limit_beside_moving(const pbd::MotionView& motion, const pbd::ContactView& contacts, float furthest);
  shape_contact_kernels::Touches touches(pbd::View<const pbd::Phase> phase, uint32_t sorted) const {
    return {phase, filters_.view(), pieces_.view(), contact_radius_, attached_, points_, sorted};
  }
  /// Finds the shapes that are within `reach` (m) of the particles' positions.
  CandidateView find_near(pbd::View<const pbd::Vec4> position, uint32_t particles, float reach);

  const ShapeSet& shapes() const { return shapes_; }
  /// The largest contact radius of all fluids and pieces of cloth, m.
  float largest_radius() const { return largest_radius_; }

 private:
  ParticleWorlds worlds() const;
  template <bool only_fixed_planes>
  auto finder(const pbd::Substep<D>& substep) const;
  /// A tank with nothing in it, which is common: its kernels need a third of the registers.
  bool only_fixed_planes() const { return fixed_are_planes_ && !any_moving(); }

  D& device_;
  pbd::Particles& particles_;
  float support_radius_, contact_radius_, largest_radius_;
  ShapeSet shapes_;
  bool fixed_are_planes_ = true;
  uint32_t room_ = 0;  // particles
  Candidates candidates_;
  pbd::Buffer<CollisionFilter> filters_;
  pbd::Buffer<Touch> pieces_;
  AttachedBodies attached_;
  PointTriangles points_;
};

}  // namespace meniscus::collision
