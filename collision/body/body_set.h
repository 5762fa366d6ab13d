// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraint set that couples rigid bodies with particles, by way of proxies and impulses.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "collision/body/body_kernels.h"
#include "collision/body/fixed_sums.h"
#include "collision/contact/shape_contacts.h"
#include "collision/rigid/rigid_worlds.h"
#include "collision/rigid_contact/rigid_contact_set.h"
#include "pbd/device/shared_buffer.h"
#include "pbd/device/side_thread.h"
#include "pbd/substep.h"

namespace meniscus::collision {

/// Couples rigid bodies with particles. In a substep,
///
///   predict   places a proxy for each body, predicted with the forces that Bullet will integrate. From here
///             on Bullet finds its contacts, on a thread of its own;
///   begin     groups the contacts by body, and splits each body among its contacts;
///   project   after the other sets, moves the proxies by the impulses of their contacts, and the planes of
///             the contacts with them. So the other sets see the displaced body;
///   end       sums the impulses;
///   exchange  transfers them to Bullet, which advances. Its poses are authoritative. A particle that ends on
///             the wrong side, because another body stopped its body, is rolled back.
///
/// In a world that ranks share, all ranks have all bodies. Each has the contacts of its own particles. They
/// add up how many there are and what they do to bodies, as integers. So all advance the same rigid world.
///
/// Particles and bodies exchange equal and opposite impulses at one point. So linear momentum is conserved to
/// rounding, and angular momentum to the order of the substep.
template <class D>
class BodySet final : public pbd::ConstraintSet<D> {
 public:
  BodySet(D& device, RigidWorld& world, ShapeContacts<D>& contacts)
      : device_(device), world_(world), worlds_(world), contacts_(contacts), solid_contacts_(device) {
    if (world.is_on_device()) world.set_contacts(&solid_contacts_);
  }
  ~BodySet() override {
    if (world_.is_on_device()) world_.set_contacts(nullptr);
  }
  BodySet(const BodySet&) = delete;
  BodySet& operator=(const BodySet&) = delete;

  /// Must be called when the bodies of the world change, or the shapes that they carry. The view must stay
  /// valid until the next call.
  void set_shapes(std::span<const CarriedShape> carried, pbd::View<Shape> shapes);
  /// The rigid worlds. In a batch, call set_shapes() after there are many.
  RigidWorlds& worlds() { return worlds_; }
  const RigidWorlds& worlds() const { return worlds_; }
  /// Gives these worlds of a batch, by world ≠ 0, the rigid state and the forces of make_many().
  void reset_bodies(std::span<const uint32_t> chosen);
  /// Gives them those before the last step.
  void undo_bodies(std::span<const uint32_t> chosen);
  /// Resets the mean forces on a body that is destroyed, so that the next body with its number starts with
  /// none.
  void forget_forces(uint32_t body);
  /// Call it when velocities of bodies have changed within a step.
  void motions_changed() { ahead_ = -1; }
  /// By body: impulses of the substep that are known when contacts are summed, beside those of contacts.
  /// Empty if there are none. The view must stay valid until the next call.
  void set_loads(pbd::View<const RigidImpulse> loads) { loads_ = loads; }
  /// Moves the shapes to the bodies' current poses.
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
  /// Not of the rigid world. Call place() first, when that is restored.
  void visit_state(pbd::StateVisitor& v) { v.list("mean_force", mean_forces_); }

  /// By body: its predicted pose. Contact searches that run after the prediction read this.
  pbd::View<const BodyProxy> proxies() const { return proxies_.view(); }
  /// By body: its motion in the present substep, as predicted. For the host.
  std::span<const RigidMotion> host_motions() const { return motion_.host(); }
  /// By body with contacts: its displacement by these contacts so far in the substep.
  pbd::View<const body_kernels::ContactMotion> contact_motions() const {
    return contact_motion_.current.view();
  }
  /// By body: its motion over the substep, as Bullet would integrate it without contacts.
  pbd::View<const RigidMotion> motions() const { return motion_.view(); }
  /// By body: m, from its centre to its outermost point.
  pbd::View<const float> reaches() const { return reaches_.view(); }
  /// By body: m/s², what particles did to its outermost point in the last step. Set by speed().
  pbd::View<const float> accelerations() const { return acceleration_.view(); }
  /// Sums up what contacts have done to bodies so far in the substep: lanes() elements a body.
  pbd::View<const body_kernels::ContactSum> sum(pbd::Substep<D>& substep) {
    sum_contacts(substep);
    return partial_.view();
  }
  uint32_t lanes() const;
  /// By body: impulses of the substep besides those of contacts, kg·m. BodyZones adds them.
  pbd::View<body_kernels::ContactSum> zone_impulses() { return zone_impulses_.view(); }
  /// Whether there are bodies that particles can move.
  bool any_moved() const { return any_moved_; }
  /// The host's time that Bullet took in the last step, ms.
  double step_ms() const { return step_ms_; }
  /// By body: the mean force and torque that particles exerted on it in the last step, N and N·m.
  std::span<const RigidImpulse> mean_forces() const { return mean_forces_; }
  void set_mean_forces(uint32_t world, std::span<const RigidImpulse> forces) {
    std::ranges::copy(forces, mean_forces_.begin() + world * worlds_.each());
  }

 private:
  void sum_contacts(pbd::Substep<D>& substep);
  void start_held(pbd::Substep<D>& substep);
  void free_held(pbd::Substep<D>& substep, bool gives_back);
  void move_held(pbd::Substep<D>& substep, bool is_last);
  void count_over_ranks(pbd::GhostExchange& ranks);
  void add_over_ranks(pbd::GhostExchange& ranks);
  void predict_motions(float dt);
  void predict_among_solids(float dt);
  template <class Place>
  void place_bodies(const char* name, const Place& place);
  void rest();
  void keep_forces();
  template <class Back, class From>
  void take_back(std::span<const uint32_t> chosen, const Back& back, const From& from);
  void begin_rigid_step(float dt);
  void finish_rigid_step(float dt, bool is_last);
  template <class F>
  void time_rigid(const F& step);
  float furthest_motion(uint32_t first, uint32_t end) const;

  D& device_;
  RigidWorld& world_;  // the one world
  RigidWorlds worlds_;
  ShapeContacts<D>& contacts_;
  uint32_t bodies_ = 0;
  bool any_moved_ = false;    // whether particles can move any body
  bool any_held_ = false;     // in the present substep
  std::vector<float> reach_;  // m, from each body's centre to its outermost point
  std::vector<RigidImpulse> sums_, mean_forces_, mean_forces_before_;
  std::vector<RigidImpulse> kept_forces_;  // of one world of a batch, as it was made
  std::vector<float> furthest_;            // m, by world: see furthest_motion()
  float step_time_ = 0;                    // s, of the substeps so far
  double step_ms_ = 0;
  float ahead_ = -1;                    // s: the time for which motion_ is predicted; -1: none
  double start_time_ = 0;               // s, of the world
  bool begun_ = false, ended_ = false;  // in the present step
  RigidContactSet<D> solid_contacts_;

  pbd::SharedBuffer<RigidMotion> motion_{device_, "body motions"};
  pbd::SharedBuffer<RigidMotion> arrived_{device_, "body poses"};
  pbd::SharedBuffer<RigidImpulse> impulses_{device_, "body impulses"};
  pbd::Buffer<RigidMass> mass_{device_, "body masses"};
  pbd::SharedBuffer<float> acceleration_{device_, "body accelerations"};
  pbd::Buffer<float> reaches_{device_, "body reaches"};
  pbd::Buffer<BodyProxy> proxies_{device_, "body proxies"};
  pbd::Buffer<CarriedShape> carried_{device_, "carried shapes"};
  pbd::View<Shape> shapes_;
  pbd::View<const RigidImpulse> loads_;
  pbd::Buffer<body_kernels::ContactSum> partial_{device_, "body sums"};
  pbd::Buffer<body_kernels::IntegerSum> integer_sums_{device_, "body sums"};      // of fixed sums alone
  pbd::Buffer<body_kernels::IntegerSum> totals_{device_, "body sums"};            // of a shared world
  pbd::Buffer<body_kernels::GroupCounts> counts_{device_, "contacts of bodies"};  // likewise
  pbd::Buffer<body_kernels::ContactSum> zone_impulses_{device_, "impulses of body zones"};
  pbd::Buffer<HeldBody> held_{device_, "held bodies"};
  pbd::Buffer<Sym6> riding_{device_, "held bodies"};
  pbd::Buffer<uint32_t> on_cloth_{device_, "held bodies"};
  pbd::DoubleBuffer<body_kernels::ContactMotion> contact_motion_{device_, "body displacements"};
  pbd::Buffer<uint32_t> key_{device_, "contact bodies"};
  pbd::Buffer<uint32_t> sorted_key_{device_, "contact bodies"};
  pbd::Buffer<uint32_t> number_{device_, "contact numbers"};
  pbd::Buffer<uint32_t> grouped_{device_, "contacts by body"};
  pbd::SideThread side_;  // last: its thread ends before the members that it uses are destroyed
};

}  // namespace meniscus::collision
