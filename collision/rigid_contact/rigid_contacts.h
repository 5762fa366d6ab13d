// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids that a device solves, as the rigid world sees them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "collision/rigid_contact/ground.h"
#include "collision/rigid_contact/hull.h"
#include "pbd/contacts.h"

namespace meniscus::collision {

/// A convex part of a solid. Parts of bodies come first, by body. Each key is unique.
struct ContactPart {
  Convex shape;
  Pose pose;                            ///< in the body's frame; of a fixed part in the world
  uint32_t body = pbd::no_index;        ///< no_index: fixed
  float friction = 0, restitution = 0;  ///< square roots: two solids have the products
  uint32_t groups = 0, mask = 0;
  uint64_t key = 0;  ///< the same as long as the solid lives
};

/// The parts of a solid, with their hulls and grounds: part.shape.table is a place there.
struct ContactSolid {
  std::vector<ContactPart> parts;
  std::vector<std::shared_ptr<const ContactHull>> hulls;
  std::vector<std::shared_ptr<const ContactGround>> grounds;
};

/// A body at the start of a step.
struct ContactBody {
  Pose pose;  ///< of the principal frame
  Vec3 velocity, angular;
  float inverse_mass;        ///< 1/kg; 0: contacts do not move it
  Vec3 inverse_inertia;      ///< 1/(kg m²), principal
  Vec3 acceleration;         ///< m/s², by gravity and forces
  Vec3 torque;               ///< N·m, of the world
  float kept, angular_kept;  ///< fraction of its velocities that damping leaves in a small step
};

struct ContactMotion {
  Pose pose;
  Vec3 velocity, angular;
  bool touches;  ///< has contacts with solids, or may have them within the step
};

struct ContactStep {
  float dt;            ///< s
  int small_steps;     ///< that it is made of
  float least_bounce;  ///< m/s: slower contacts do not bounce
};

/// A point of a contact in the last step, with what it starts from in the next one.
struct SavedContact {
  uint64_t key_a, key_b;  ///< of the two parts
  uint32_t feature;
  float pressure;  ///< N, along the normal
  Vec3 friction;   ///< N
  Vec3 position;   ///< m, between both surfaces, when it was found
  Vec3 normal;     ///< from b to a
  float distance;  ///< m
  float impulse;   ///< N·s
};

/// The bodies of a contact; no_index: a fixed solid.
struct ContactBodies {
  uint32_t a, b;
};

/// The keys of two parts.
struct TouchingParts {
  uint64_t a, b;
};

class RigidContacts {
 public:
  virtual ~RigidContacts() = default;

  /// Replaces all parts. Contacts of parts that stay keep what they start from.
  virtual void set_parts(const ContactSolid& all) = 0;
  /// Finds the contacts of a step that may last dt (s). Velocities and accelerations say how far ahead.
  virtual void find(std::span<const ContactBody> bodies, float dt) = 0;
  /// Those that find() has found, by contact. Bodies that contacts do not move have none with one another.
  virtual std::vector<ContactBodies> found() = 0;
  /// Advances the bodies from where find() has them, with forces that may differ. The result does not depend
  /// on earlier calls since find().
  virtual void advance(std::span<const ContactBody> bodies, const ContactStep& step,
                       std::span<ContactMotion> out) = 0;
  /// Makes the last advance() what the next step starts from.
  virtual void accept() = 0;

  /// The parts that touched in the last step that was accepted, or restored: with a distance ≤ 0 or an
  /// impulse at any point. A pair may come more than once.
  virtual std::vector<TouchingParts> touching() = 0;

  /// Keeps what the next step starts from, without a copy on the host. The memory of the last call is used
  /// again.
  virtual void keep() = 0;
  /// Gives back what keep() kept, once. The parts must be the same.
  virtual void take_back() = 0;

  /// All contacts of the last step that was accepted, or restored.
  virtual std::vector<SavedContact> save() = 0;
  virtual void restore(std::span<const SavedContact> saved) = 0;
};

}  // namespace meniscus::collision
