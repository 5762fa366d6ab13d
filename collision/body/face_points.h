// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that gives faces of cloth their own contacts with solids, by particles for one substep.
#pragma once

#include <span>

#include "collision/body/body_set.h"
#include "collision/body/face_points_kernels.h"
#include "collision/contact/contact_set.h"
#include "pbd/device/shared_buffer.h"

namespace meniscus::collision {

/// Keeps sharp features from passing between the vertices of cloth: one contact with solids for each face
/// (Macklin et al. 2020, see face_points_nearest.h), besides those of the vertices.
///
/// The point of a face that is nearest to a solid becomes a particle for one substep, after all others.
/// Contacts are found and solved for it as for any particle. Takes ContactSet's place among the sets:
///
///   arrange   finds which faces need a point, and makes the particles;
///   begin     counts the points at each vertex;
///   project   moves the points to their triangles and sets their masses, lets ContactSet project all
///             contacts, and transfers the points' displacements to the vertices;
///   settle    is the fail-safe: it moves out the faces that the iterations have left inside;
///   end       does the same with velocities as project.
///
/// The transfer keeps impulses, so momentum is conserved. A point between held vertices is held as well: w =
/// 0, and it records the impulse that it withstands, as they do. While no face needs a point, a substep costs
/// one launch.
template <class D>
class FacePoints final : public pbd::ConstraintSet<D> {
 public:
  FacePoints(D& device, pbd::Particles& particles, ShapeContacts<D>& shapes, const BodySet<D>& bodies,
             ContactSet<D>& contacts)
      : device_(device), particles_(particles), shapes_(shapes), bodies_(bodies), contacts_(contacts) {
    wanted_.resize_discard(1);
    wanted_.host()[0] = 0;
  }

  /// Sets all faces, of so many worlds. The view must stay valid until the next call.
  void set_surface(const pbd::SurfaceView& surface, uint32_t worlds = 1);
  /// The largest number of points that a substep of the last step needed.
  uint32_t wanted() const { return wanted_.host()[0]; }

  uint32_t extra_particles() const override { return room_; }
  void save() override;
  void start_step() override { wanted_.host()[0] = 0; }
  void visit_state(pbd::StateVisitor& v);
  void arrange(pbd::Substep<D>& substep) override;
  bool prepares() const override { return may_need_points() && !active_; }
  void prepare(pbd::Substep<D>& substep) override;
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void settle(pbd::Substep<D>& substep) override;
  void end(pbd::Substep<D>& substep) override;
  bool had_room() const override { return wanted() <= (active_ ? room_ : 0); }
  void make_room() override;

 private:
  void set_room(uint32_t points);
  /// Whether any face may need a point.
  bool may_need_points() const;
  void decide(const pbd::Substep<D>& substep, pbd::View<uint32_t> needed);
  face_kernels::Points points(const pbd::Substep<D>& substep) const;
  /// Whether points take part. They do not while the solver only measures or relaxes.
  bool any(const pbd::Substep<D>& substep) const {
    return active_ && substep.particles.owned > particles_.count();
  }

  D& device_;
  pbd::Particles& particles_;
  ShapeContacts<D>& shapes_;
  const BodySet<D>& bodies_;
  ContactSet<D>& contacts_;
  uint32_t vertices_ = 0;  // number of vertices of the faces
  uint32_t worlds_ = 1;
  uint32_t room_ = 0;    // number of points
  bool active_ = false;  // whether points are in use; else faces are only tested
  uint32_t idle_ = 0;    // consecutive steps that needed no point

  pbd::SurfaceView surface_;
  pbd::Buffer<uint32_t> needed_{device_, "face flags"}, number_{device_, "face point numbers"};
  pbd::Buffer<pbd::Vec4> weights_{device_, "face point weights"};
  pbd::Buffer<uint32_t> triangle_of_{device_, "face points"};
  pbd::Buffer<uint32_t> pushed_{device_, "face points that push"};
  pbd::Buffer<pbd::Vec4> demand_{device_, "face point demands"};
  pbd::Buffer<uint32_t> at_vertex_{device_, "face points by vertex"};
  pbd::SharedBuffer<uint32_t> wanted_{device_, "face points wanted"};
};

}  // namespace meniscus::collision
