// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid bodies as Bullet simulates them, without Bullet's types. Particles act on bodies only by one impulse
// per body and substep.
#pragma once

#include <meniscus/bodies.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "collision/mesh/mass_properties.h"
#include "collision/mesh/mesh.h"
#include "collision/rigid/rigid_layout.h"
#include "collision/rigid/rigid_motion.h"
#include "pbd/contacts.h"

namespace meniscus::collision {

class BulletReserve;
class RigidContacts;

/// One part of a solid, as Bullet represents it.
struct RigidPart {
  enum class Kind { box, sphere, capsule, cylinder, hull, mesh, height_field, plane };
  Kind kind = Kind::box;
  Pose pose{};                  ///< in the geometry's frame
  Vec3 size{0.5f, 0.5f, 0.5f};  ///< box: half extents; round parts: radius, half height; plane: unit normal
  float offset = 0;             ///< plane: normal · p on the surface, m
  std::shared_ptr<const TriangleMesh>
      mesh{};  ///< hull: of its vertices; mesh: its triangles, for fixed and kinematic solids
  HeightFieldGeometry heights{};
};

/// Parts with the material and filter for Bullet.
struct RigidSolid {
  std::vector<RigidPart> parts;
  Pose pose{};  ///< of the geometry's frame
  float friction = 0.5f, restitution = 0;
  CollisionFilter filter{};
};

struct RigidBodyDef {
  RigidSolid solid;
  BodyMotion motion = BodyMotion::dynamic;
  MassProperties mass{};  ///< not used by kinematic bodies
  Vec3 velocity{0, 0, 0}, angular_velocity{0, 0, 0};
  float linear_damping = 0, angular_damping = 0;
  bool can_sleep = true;
  std::vector<Keyframe> keyframes;  ///< kinematic: if there are any, they give the pose from the start
  bool loop = false;                ///< the last keyframe should have the pose of the first
  std::string name{};               ///< for errors
};

struct RigidJointDef {
  uint32_t a = 0;
  uint32_t b = pbd::no_index;  ///< no_index: the world
  Pose frame{};                ///< world
  JointKind kind;
  bool bodies_collide = false;
};

struct RigidWorldDef {
  Vec3 gravity{0, -9.81f, 0};
  int substeps = 1;        ///< of Bullet, in one call of step()
  int iterations = 10;     ///< of Bullet's solver; on a device, how often each contact is visited
  bool on_device = false;  ///< contacts are solved by set_contacts(), not by Bullet
};

/// Refers to a solid of this world: a body by its number, or a fixed solid.
struct RigidRef {
  bool is_body = false;
  uint32_t number = pbd::no_index;
};

struct RigidContact {
  RigidRef a, b;   ///< a is a body; b may be one
  Vec3 point;      ///< m, on b
  Vec3 normal;     ///< unit, from b to a
  float distance;  ///< m
  float impulse;   ///< N·s, in the last of Bullet's `substeps` steps
};

struct RigidTouch {
  RigidRef a, b;  ///< in a fixed order: bodies before fixed solids, then by number
};

struct RigidOverlap {
  RigidRef a, b;  ///< a is a dynamic body; b may be one, of a higher number
  float depth;    ///< m
};

struct RigidRayHit {
  RigidRef solid;
  Vec3 point, normal;
  float fraction;  ///< of the ray
};

class RigidWorld {
 public:
  explicit RigidWorld(const RigidWorldDef& def);
  ~RigidWorld();

  void swap(RigidWorld& other) noexcept;

  /// Solves the contacts of a world with `on_device`. It must live until it is replaced, by nullptr at last.
  /// swap() leaves it with this world.
  void set_contacts(RigidContacts* contacts);
  bool is_on_device() const;

  /// Whether memory ran out inside Bullet. Then nothing else may be called, and its memory is never freed.
  bool is_broken() const;

  /// Takes effect at the next step; all bodies wake.
  void set_def(const RigidWorldDef& def);

  // Solids, bodies and joints have numbers. A number that is released is used again, the lowest first. Adding
  // something does not change what is there.
  uint32_t add_fixed(const RigidSolid& solid, const RigidPlace& place = {});
  uint32_t add_body(const RigidBodyDef& def, const RigidPlace& place = {});
  /// Removes bodies, with their joints, and fixed solids. The result is that of removing one at a time, in
  /// this order. Bullet's lists are gone
  /// through once for all. Changes nothing if it throws.
  void remove(std::span<const RigidRef> solids);
  void remove(const RigidRef& solid) { remove(std::span(&solid, 1)); }
  /// The joints of a body, ascending.
  const std::vector<uint32_t>& joints_of(uint32_t body) const;
  uint32_t add_joint(const RigidJointDef& def);
  /// With this number and these poses of its bodies, which stay at them. Both are in their places already.
  void add_joint(const RigidJointDef& def, uint32_t number, const JointPlaces& places);
  void remove_joint(uint32_t number);
  bool has_joint(uint32_t number) const;  ///< joints are removed with their bodies

  /// The highest number in use plus 1, which is the size of arrays by body number. Unused numbers read as
  /// bodies without mass and motion.
  uint32_t body_slots() const;
  uint32_t body_count() const;
  RigidMass mass(uint32_t body) const;

  // State. Poses are of the geometry's frame, velocities of the centre of mass.
  Pose pose(uint32_t body) const;
  Vec3 velocity(uint32_t body) const;
  Vec3 angular_velocity(uint32_t body) const;
  Vec3 centre_of_mass(uint32_t body) const;
  bool awake(uint32_t body) const;
  /// By number: 1 for a body that is awake, and for a number that is not in use.
  void read_awake(std::vector<uint8_t>& out) const;
  void set_pose(uint32_t body,
                const Pose& pose);  ///< wakes it; a kinematic body has no velocity afterwards
  void set_velocity(uint32_t body, Vec3 velocity, Vec3 angular_velocity);  ///< dynamic bodies; wakes
  void wake(uint32_t body);
  // These wake what touches the solid, before and after.
  void set_fixed_pose(uint32_t number, const Pose& pose);  ///< of the geometry's frame
  void set_filter(const RigidRef& solid, const CollisionFilter& filter);
  void set_surface(const RigidRef& solid, float friction, float restitution);
  /// Keeps exactly these bodies from falling asleep. The forces on them change while they hardly move.
  void keep_awake(std::span<const uint32_t> bodies);
  /// Acts until the next end_step(): N at a world point, N·m.
  void apply_force(uint32_t body, Vec3 force, Vec3 point);
  void apply_torque(uint32_t body, Vec3 torque);
  RigidImpulse pending(uint32_t body) const;  ///< the sums of these: N, and N·m about the centre of mass
  void apply_impulse(uint32_t body, Vec3 impulse, Vec3 point);  ///< at once
  /// Sets the target of a kinematic body, which it reaches at a constant rate after `duration` (s). Replaces
  /// its keyframes.
  void move(uint32_t body, const Pose& target, float duration);
  float hinge_angle(uint32_t joint) const;  ///< rad, from the placement at creation; 0 for other kinds

  // ---- a substep of length dt, in this order ----

  /// By number: the poses of bodies and their predicted motion over dt without contacts; with dt = 0 the
  /// poses alone.
  void predict(float dt, std::span<RigidMotion> out) const;
  /// Finds contacts at the bodies' current poses, which takes a large part of a step. Impulses need not be
  /// known yet.
  void begin_step(float dt);
  /// After begin_step(), on a device: as predict(), with contacts among solids.
  void predict_among_solids(float dt, std::span<RigidMotion> out) const;
  /// Applies the impulse of each body, wakes the bodies that an impulse changes, and advances by dt.
  void finish_step(float dt, std::span<const RigidImpulse> impulses);
  /// Does both.
  void step(float dt, std::span<const RigidImpulse> impulses) {
    begin_step(dt);
    finish_step(dt, impulses);
  }
  /// Sets the time. Replaces a step where there are no bodies.
  void set_time(double time);
  /// Throws Error(non_finite) with the name of the first body whose pose or velocity is not finite.
  void check_finite() const;
  /// Ends a series of steps: clears applied forces.
  void end_step();
  double time() const;  ///< s

  // ---- queries ----

  std::vector<RigidContact> contacts() const;  ///< of the last step, in a fixed order
  /// Pairs with at least one point at distance ≤ 0 or an impulse, sorted. Computed at the first call after a
  /// step, and kept until something changes.
  const std::vector<RigidTouch>& touches();
  /// Finds the nearest hit. A ray that starts in a convex solid meets it at once.
  bool cast_ray(Vec3 from, Vec3 to, RigidRayHit& hit) const;
  /// Solids that overlap a box or, with a radius, a ball (half_extents.x is the radius).
  std::vector<RigidRef> overlaps(const Pose& pose, Vec3 half_extents, bool ball) const;

  /// The pairs that may collide and overlap now by more than a fraction of the smaller one's radius.
  std::vector<RigidOverlap> deep_overlaps(float fraction) const;

  // ---- state in memory ----

  /// All state that the future depends on. Saving into the same snapshot again reuses its memory. The world
  /// that restores it must have the same contents in the same places: none was added, removed or set since,
  /// or it has been made again by a layout(). The continuation is then equal bit for bit.
  struct Snapshot;
  struct DeleteSnapshot {
    void operator()(Snapshot*) const;
  };
  using SnapshotPtr = std::unique_ptr<Snapshot, DeleteSnapshot>;
  static SnapshotPtr make_snapshot();
  void save(Snapshot& snapshot) const {
    save_bodies(snapshot);
    save_contacts(snapshot);
  }
  void save_bodies(Snapshot& snapshot) const;    ///< one half; both may be saved at once
  void save_contacts(Snapshot& snapshot) const;  ///< the other one
  /// The other one as well, without a copy from the device. It is for one restore(), before the next call of
  /// this, and while solids stay the same.
  void keep_contacts(Snapshot& snapshot) const;
  void restore(const Snapshot& snapshot);
  /// The items of a snapshot. One that they fill is for this world. Throws Error(io) if the items do not fit.
  void visit_snapshot(Snapshot& snapshot, pbd::StateVisitor& v) const;

  /// Where all contents stand. A new world that has been given the same contents in these places stands alike
  /// after arrange(); then its state may be restored. Throws Error(io) if they do not fit.
  RigidLayout layout() const;
  void arrange(const RigidLayout& layout);

 private:
  void save_in_bullet(Snapshot& snapshot) const;
  void expect_valid(const Snapshot& snapshot) const;

  struct Impl;
  struct DeleteImpl {
    void operator()(Impl*) const;
  };
  std::unique_ptr<BulletReserve> reserve_;
  std::unique_ptr<Impl, DeleteImpl> impl_;
};

}  // namespace meniscus::collision
