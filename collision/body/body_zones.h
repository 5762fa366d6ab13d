// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The fail-safe between bodies and cloth: impact zones in which a body is one rigid member.
#pragma once

#include <span>
#include <vector>

#include "collision/body/body_set.h"
#include "collision/body/body_zones_move.h"

namespace meniscus::collision {

/// Keeps bodies from passing through cloth, whatever error the solve has left.
///
/// Each face is followed over the substep in the frame of each body near it, by conservative advancement.
/// Where it would come too near, its vertices and the body unite in an impact zone. A zone moves as one rigid
/// body from where the substep began, with the linear and the angular momentum of its members. So the impact
/// is inelastic, and within a zone nothing moves relative to the body. Zones are found in rounds, as one may
/// meet further faces. In the last round all of the piece joins.
///
/// Zones are no good solution: they stretch the cloth around them. So the step has as many substeps as it
/// takes for no body to move much further than a face in one, relative to the cloth that it meets.
///
/// settle() does this, after all that moves vertices but the fail-safe of cloth with cloth. While nothing
/// would pass, it costs one launch.
template <class D>
class BodyZones final : public pbd::ConstraintSet<D> {
 public:
  BodyZones(D& device, ShapeContacts<D>& shapes, BodySet<D>& bodies)
      : device_(device), shapes_(shapes), bodies_(bodies) {
    found_.resize_discard(1);
    found_.host()[0] = 0;
    needed_.resize_discard(1);
  }

  /// Sets all faces on the device, those of one world on the host, and the number of its pieces of cloth. The
  /// view must stay valid until the next call.
  void set_surface(const pbd::SurfaceView& surface, std::span<const pbd::SurfaceTriangle> triangles,
                   std::span<const Vec3> rest, size_t pieces, uint32_t worlds = 1);

  /// Whether steps may need more substeps than others.
  bool may_need_substeps() const { return surface_.triangles.count > 0 && shapes_.any_moving(); }
  /// By world, for a step that starts in this state. Call it after BodySet::speed().
  std::span<const uint32_t> least_substeps_by_world(float dt, const pbd::ParticleView& start);
  /// The number of substeps for a world that needs so many, of which `chosen` is the least.
  static int in_range(uint32_t needed, int chosen);
  /// The most of all worlds that step.
  int least_substeps(float dt, int chosen, const pbd::ParticleView& start) override;
  void save() override;
  void start_step() override { found_.host()[0] = 0; }
  void visit_state(pbd::StateVisitor& v) {
    v.value("active", active_);
    v.value("idle", idle_);
    v.values("found", found_.host());
  }
  void arrange(pbd::Substep<D>&) override { moves_ = true; }
  void project(pbd::Substep<D>&, int) override {}
  void settle(pbd::Substep<D>& substep) override;
  bool had_room() const override { return active_ || found_.host()[0] == 0; }
  void make_room() override { active_ = true; }

 private:
  void reserve_zones();
  zone_kernels::Zones zones();
  void find(pbd::Substep<D>& substep, uint32_t round, const pbd::View<const BodyProxy>& bodies);

  D& device_;
  ShapeContacts<D>& shapes_;
  BodySet<D>& bodies_;
  pbd::SurfaceView surface_;
  uint32_t vertices_ = 0, pieces_ = 0, worlds_ = 1;
  bool active_ = false;  // whether zones are in use; else faces are only tested
  bool moves_ = false;   // whether the substep is one of a step
  uint32_t idle_ = 0;    // consecutive steps that needed no zone

  pbd::Buffer<uint32_t> label_{device_, "body zones"}, grown_{device_, "body zones"},
      anchor_{device_, "body zones"}, zone_of_{device_, "body zones"}, piece_zone_{device_, "body zones"},
      crossings_{device_, "body zones"};
  pbd::Buffer<zone_kernels::ZoneMotion> motion_{device_, "body zones"};
  pbd::Buffer<Pose> pose_{device_, "body zones"};
  pbd::Buffer<Vec3> turn_{device_, "body zones"};
  pbd::Buffer<zone_kernels::ZoneSum> partial_{device_, "body zone sums"};
  pbd::Buffer<float> sizes_{device_, "sizes of faces"};
  pbd::SharedBuffer<uint32_t> found_{device_, "body zones"}, needed_{device_, "substeps for fast bodies"};
};

}  // namespace meniscus::collision
