// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What World::state_hash sums up beside the particles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pbd/math/hash.h"
#include "sdk/world/state/body_calls.h"

namespace meniscus {

/// Each kind of element has numbers of its own, different from those of the particles.
enum class HashedKind : uint64_t { cloth = 1, rope, body };

inline uint64_t element_number(HashedKind kind, uint32_t owner, std::size_t part) {
  return pbd::mixed(static_cast<uint64_t>(kind) << 32 | owner) + part;
}

inline uint64_t element_hash(HashedKind kind, uint32_t owner, std::size_t part, Vec3 a, Vec3 b) {
  return pbd::element_hash(element_number(kind, owner, part), a, b);
}

/// The sum over all bodies, in the state of a rigid world.
inline uint64_t hash_bodies(const IdTable<BodyId, BodyEntry>& bodies, const collision::RigidWorld& rigid) {
  uint64_t sum = 0;
  bodies.for_each([&](uint32_t number, const BodyEntry&) {
    const Pose pose = rigid.pose(number);
    const Quat q = pose.rotation;
    sum += element_hash(HashedKind::body, number, 0, pose.position, rigid.velocity(number));
    sum += element_hash(HashedKind::body, number, 1, {q.x, q.y, q.z}, {q.w, 0, 0});
    sum += element_hash(HashedKind::body, number, 2, rigid.angular_velocity(number), {});
  });
  return sum;
}

}  // namespace meniscus
