// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "collision/body/body_kernels.h"
#include "collision/contact/shape_contacts.h"
#include "collision/rigid/rigid_world.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/device/side_thread.h"
#include "pbd/substep.h"

namespace meniscus::collision {

/// Rigid bodies among the particles. In a substep,
///
///   predict   stands a proxy for each body, predicted with the forces that Bullet will integrate. From here
///             on Bullet finds who touches whom, on a thread of its own;
///   begin     groups the contacts by body, and splits each body among its contacts;
///   project   after the other sets, moves the proxies by what their contacts have gathered, and the planes
///             of the contacts along: the other sets find the body where it has given way to;
///   end       sums the impulses;
///   exchange  hands them to Bullet, which advances; its poses are the truth. What a body that was stopped by
///             another would leave on the wrong side is taken along.
///
/// Particles and bodies exchange equal and opposite impulses at one point, so that linear momentum is kept to
/// rounding, and angular momentum to the order of the substep.
template <class D>
class BodySet final : public pbd::ConstraintSet<D> {
 public:
  BodySet(D& device, RigidWorld& world, ShapeContacts<D>& contacts)
      : device_(device), world_(world), contacts_(contacts), snapshot_(RigidWorld::make_snapshot()) {}

  /// The bodies of the world have changed, or what they carry. The view must stay valid until it is set anew.
  void set_shapes(std::span<const CarriedShape> carried, pbd::View<Shape> shapes);
  /// Of one that is destroyed: what comes to its place had none.
  void forget_forces(uint32_t body);
  /// Brings the shapes to where the bodies are now.
  void place();

  float speed(float dt) override;
  void predict(float dt) override;
  void begin(pbd::Substep<D>& substep) override;
  void project(pbd::Substep<D>& substep, int iteration) override;
  void end(pbd::Substep<D>& substep) override;
  bool exchanges() const override { return bodies_ > 0; }
  void exchange(pbd::Substep<D>& substep) override;
  void start_step() override;
  void end_step() override;
  void undo_step() override;

  /// By body: where it is predicted to be. For what is found once bodies are predicted.
  pbd::View<const BodyProxy> proxies() const { return proxies_.view(); }
  /// By body, of those that have contacts: what these have moved it by so far in the substep.
  pbd::View<const body_kernels::ContactMotion> contact_motions() const {
    return contact_motion_.current.view();
  }
  /// Whether there are bodies that particles can move.
  bool any_moved() const { return any_moved_; }
  /// What Bullet took of the host's time in the last step, ms.
  double step_ms() const { return step_ms_; }
  /// By body: what the particles gave it in the last step, over the step's length. N and N·m.
  std::span<const RigidImpulse> mean_forces() const { return mean_forces_; }

 private:
  void sum_contacts(pbd::Substep<D>& substep);
  void look_ahead(float dt);
  template <class Place>
  void place_bodies(const char* name, const Place& place);
  void rest();
  void begin_rigid_step(float dt);
  template <class F>
  void time_rigid(const F& step);
  float furthest_motion() const;
  uint32_t lanes() const;

  D& device_;
  RigidWorld& world_;
  ShapeContacts<D>& contacts_;
  uint32_t bodies_ = 0;
  bool any_moved_ = false;    // by particles
  std::vector<float> reach_;  // m, of each body's outermost point from its centre
  std::vector<RigidImpulse> sums_, mean_forces_, mean_forces_before_;
  float step_time_ = 0;  // s, of the substeps so far
  double step_ms_ = 0;
  float ahead_ = -1;                    // s: what motion_ has been predicted for; -1: nothing
  double start_time_ = 0;               // s, of the world
  bool begun_ = false, ended_ = false;  // in the present step
  RigidWorld::SnapshotPtr snapshot_;

  pbd::SharedBuffer<RigidMotion> motion_{device_, "body motions"};
  pbd::SharedBuffer<RigidMotion> arrived_{device_, "body poses"};
  pbd::SharedBuffer<RigidImpulse> impulses_{device_, "body impulses"};
  pbd::Buffer<RigidMass> mass_{device_, "body masses"};
  pbd::Buffer<BodyProxy> proxies_{device_, "body proxies"};
  pbd::Buffer<CarriedShape> carried_{device_, "carried shapes"};
  pbd::View<Shape> shapes_;
  pbd::Buffer<body_kernels::ContactSum> partial_{device_, "body sums"};
  pbd::DoubleBuffer<body_kernels::ContactMotion> contact_motion_{device_, "body displacements"};
  pbd::Buffer<uint32_t> key_{device_, "contact bodies"};
  pbd::Buffer<uint32_t> sorted_key_{device_, "contact bodies"};
  pbd::Buffer<uint32_t> number_{device_, "contact numbers"};
  pbd::Buffer<uint32_t> grouped_{device_, "contacts by body"};
  pbd::SideThread side_;  // last: it is through with all that it works on before that goes
};

}  // namespace meniscus::collision
