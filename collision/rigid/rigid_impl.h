// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The implementation of RigidWorld. Its functions are in rigid_world.cpp (contents), predict.cpp,
// step.cpp, joints.cpp, queries.cpp and snapshot.cpp.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "collision/mesh/bullet_memory.h"
#include "collision/rigid/broadphase.h"
#include "collision/rigid/dynamics.h"
#include "collision/rigid/kinematics.h"
#include "collision/rigid/rigid_shapes.h"
#include "collision/rigid/rigid_solver.h"
#include "collision/rigid/rigid_world.h"
#include "collision/rigid_contact/rigid_contacts.h"

namespace meniscus::collision {

/// Bullet's user type for joints with springs.
inline constexpr int spring_constraint = 1;

enum class KinematicDrive { still, keyframes, move };

/// State of a body in addition to Bullet's. It is plain data, so that it can be saved.
struct RigidMemory {
  Vec3 force{0, 0, 0}, torque{0, 0, 0};              ///< the user's, N and N·m, until end_step()
  Vec3 usual_force{0, 0, 0}, usual_torque{0, 0, 0};  ///< smoothed, of the particles, while it was awake
  Pose pose;                                         ///< kinematic bodies: pose of the geometry's frame
  KinematicDrive drive = KinematicDrive::still;
  KinematicMove move{};
  float push_work = 0, free_work = 0;  ///< J, on a device: of the usual push; if the body were free
  uint32_t island = pbd::no_index;     ///< on a device: the lowest body of those that fell asleep together
};

struct RigidBodyRecord {
  std::string name;
  RigidShape shape;
  std::unique_ptr<btRigidBody> bullet;
  bool kinematic = false;
  bool kept_awake = false;
  std::vector<Keyframe> keyframes;
  bool loop = false;
  std::vector<uint32_t> joints;  ///< their numbers, ascending
  RigidMemory memory;
  Pose from, to;                             ///< kinematic bodies: poses at both ends of the present step
  Vec3 push{0, 0, 0}, push_torque{0, 0, 0};  ///< N and N·m, of particles in the present step, if sprung
                                             ///< or on a device
  ContactSolid contact;                      ///< on a device, in the geometry's frame
};

struct RigidFixedRecord {
  RigidShape shape;
  std::unique_ptr<btRigidBody> bullet;
  ContactSolid contact;  ///< on a device, in the geometry's frame
};

struct RigidJointRecord {
  uint32_t a, b;  ///< bodies; no_index is the world
  std::unique_ptr<btTypedConstraint> bullet;
  btHingeConstraint* hinge = nullptr;
  float motor_torque = 0;  ///< N·m, of the hinge
  JointPlaces places{};    ///< from which its frames follow
  bool has_motor = false;
};

/// What was made of meshes, as long as a solid uses it.
template <class T>
struct TablesOfMeshes {
  struct Entry {
    std::weak_ptr<const TriangleMesh> mesh;
    std::weak_ptr<const T> table;
  };
  std::unordered_map<const TriangleMesh*, Entry> entries;

  template <class Make>
  std::shared_ptr<const T> of(const std::shared_ptr<const TriangleMesh>& mesh, const Make& make) {
    Entry& known = entries[mesh.get()];
    std::shared_ptr<const T> table = known.table.lock();
    // Another mesh may have had this address.
    if (table && known.mesh.lock() == mesh) return table;
    table = std::make_shared<const T>(make(*mesh));
    known = {mesh, table};
    return table;
  }
};

/// Objects by number. A free number is used again, the lowest first.
template <class T>
struct Numbered {
  std::vector<std::unique_ptr<T>> slots;
  size_t first_free = 0;  ///< below it all are taken

  /// Takes the memory that the next add() needs.
  void prepare() {
    if (slots.size() == slots.capacity()) slots.reserve(2 * slots.size() + 1);
  }
  uint32_t add(std::unique_ptr<T> thing) {
    size_t n = first_free;
    while (n < slots.size() && slots[n]) ++n;
    if (n == slots.size()) slots.emplace_back();
    slots[n] = std::move(thing);
    first_free = n + 1;
    return static_cast<uint32_t>(n);
  }
  /// At a number that is free.
  uint32_t add_at(uint32_t n, std::unique_ptr<T> thing) {
    if (n == pbd::no_index) return add(std::move(thing));
    if (slots.size() <= n) slots.resize(n + 1);
    slots[n] = std::move(thing);
    return n;
  }
  void remove(uint32_t n) {
    slots[n].reset();
    first_free = std::min<size_t>(first_free, n);
    while (!slots.empty() && !slots.back()) slots.pop_back();
  }
  bool has(uint32_t n) const { return n < slots.size() && slots[n]; }
};

struct RigidWorld::Impl {
  Impl(const RigidWorldDef& definition, BulletReserve& held_back);
  ~Impl();

  BulletReserve& reserve;
  RigidWorldDef def;
  btHashedOverlappingPairCache pairs;
  RigidFilter filter;
  btDefaultCollisionConfiguration configuration;
  RigidBroadphase broadphase;
  RigidDispatcher dispatcher;
  RigidSolver solver, joint_solver;  ///< of steps; of predictions
  RigidDynamics dynamics;
  btRigidBody ground;  ///< the body to which joints with the world attach; not in the world itself
  Numbered<RigidBodyRecord> bodies;
  Numbered<RigidFixedRecord> fixed;
  Numbered<RigidJointRecord> joints;
  double time = 0;               ///< s
  std::vector<RigidRef> solids;  ///< by the id of the proxy
  std::vector<uint64_t> touching_keys;
  std::vector<RigidTouch> touches;
  bool knows_touches = false;
  RigidContacts* contacts = nullptr;      ///< on a device
  TablesOfMeshes<ContactHull> hulls;      ///< solids that share a mesh share its hull
  TablesOfMeshes<ContactGround> grounds;  ///< likewise
  bool parts_changed = true;              ///< since `contacts` got them
  bool boxes_changed = false;             ///< since Bullet's broad phase got them
  bool may_have_islands = true;           ///< on a device: a body may have RigidMemory::island
  bool any_asleep = false;                ///< in contact_bodies
  std::vector<SavedContact> resting;      ///< contacts of sleeping bodies, which a device need not see
  std::vector<RigidRef> removed;          ///< solids that were removed since `contacts` got the parts
  std::vector<ContactBody> contact_bodies, tried_bodies;
  std::vector<ContactMotion> contact_motions, unpushed;  ///< at the end of a step; without its impulses

  /// How many solids and joints there are, as the reserve counts them.
  size_t size() const { return bodies.slots.size() + fixed.slots.size() + joints.slots.size(); }
  RigidBodyRecord& body(uint32_t n) const;
  /// Calls visit(number, body) for each, and prefetches the next ones.
  template <class Visit>
  void for_each_body(const Visit& visit) const {
    constexpr size_t ahead = 4;
    const auto& slots = bodies.slots;
    const auto is_there = [&](size_t n) { return n < slots.size() && slots[n]; };
    for (size_t n = 0; n < slots.size(); ++n) {
      if (is_there(n + 2 * ahead)) fetch_soon(slots[n + 2 * ahead].get());
      if (is_there(n + ahead)) fetch_soon(slots[n + ahead]->bullet.get());
      if (slots[n]) visit(static_cast<uint32_t>(n), *slots[n]);
    }
  }
  uint32_t make_joint(const RigidJointDef& joint, uint32_t number);
  float acceleration_scale() const;  ///< m/s², of gravity, at least 1

  /// Must be called before a change of something that others may rest on.
  void wake_around(std::span<btRigidBody* const> bodies);
  btRigidBody& bullet_of(const RigidRef& solid) const;
  void wake_near(btRigidBody& changed);
  void remove(std::span<btRigidBody* const> gone, std::span<btBroadphaseProxy* const> proxies);
  void remove_joint(uint32_t number);
  void drop_pairs();

  Pose kinematic_pose(const RigidBodyRecord& body, double at) const;
  void place_kinematic(RigidBodyRecord& body, const Pose& pose);

  struct JointedFlight;
  JointedFlight jointed_flight(float dt, std::span<const RigidMotion> motions) const;
  void predict_jointed(float dt, std::span<RigidMotion> motions);
  void take_impulses(float dt, std::span<const RigidImpulse> impulses);
  void drive_kinematics(float dt);
  void wake_driven();
  void keep_motors_awake();
  void advance_kinematics(float fraction);
  void apply_forces(float dt);
  void limit_motors(float dt);

  /// For a device, in the geometry's frame; otherwise nothing. Throws Error(invalid_argument) for parts that
  /// it has no contacts of.
  ContactSolid contact_solid(const RigidSolid& solid);
  void update_parts();
  void drop_contacts_of_removed();
  void update_boxes();
  int small_steps() const;
  ContactBody contact_body(const RigidBodyRecord& body, float h, bool pushed) const;
  void gather_bodies(float dt, bool pushed);
  void find_on_device(float dt, bool pushed);
  void try_unpushed(float dt);
  bool is_tried() const;
  bool wake_islands();
  bool wake_touched();
  void wake_beside_driven();
  void wake_resting(std::span<btRigidBody* const> changed);
  void wake_overlapping(btRigidBody& changed);
  bool note_rest(float dt);
  void fall_asleep();
  bool rests(const RigidRef& solid) const;
  bool is_removed(const RigidRef& solid) const;
  void part_resting(bool fall);
  ContactStep contact_step(float dt) const;
  void begin_on_device(float dt);
  void arrive(RigidBodyRecord& body, const ContactMotion& motion);
  void measure_yielding(RigidBodyRecord& body, uint32_t number, float dt);
  void step_on_device(float dt, bool is_first);
  RigidMotion driven_motion(const RigidBodyRecord& body, float dt) const;
  RigidMotion unpushed_motion(uint32_t number, const RigidBodyRecord& body, float dt) const;
  RigidMotion flight_on_device(const RigidBodyRecord& body, float dt) const;
  std::vector<RigidContact> contacts_on_device() const;
  std::vector<RigidTouch> touches_on_device() const;

  RigidRef solid_of(const btCollisionObject* object) const;
  /// By its code, as in RigidLayout; nullptr if there is none.
  btRigidBody* object(uint32_t code) const;
  void prepare();
  /// Adds a body or fixed solid that has its number to the world.
  void add(btRigidBody& body, const CollisionFilter& filter, const RigidPlace& place);
};

/// The velocities at the start of a step with which a body is at `target` after dt.
struct KinematicVelocity {
  Vec3 linear, angular;
};
KinematicVelocity velocity_to(const Pose& start, const Pose& target, float dt);

/// The angular velocity of a free body after dt.
btVector3 tumbled(const btRigidBody& body, const btVector3& angular, float dt);

/// A sleeping body is at rest because its other forces balance the push of particles that it fell asleep
/// under. It is predicted with these forces, so that it bears particles as it did when it was awake.
RigidMotion asleep(const btRigidBody& body, const RigidMemory& memory, float dt);

/// The solid of a part with this key.
RigidRef solid_of_key(uint64_t key);
/// By what fraction a body gives way to its usual push among solids.
float yielding_of(const RigidMemory& memory);
[[noreturn]] void refuse_joint();

void wake_up(btRigidBody& body);
void set_speed(btRigidBody& body, Vec3 linear, Vec3 angular);

}  // namespace meniscus::collision
