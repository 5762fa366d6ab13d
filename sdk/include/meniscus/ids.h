// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ids of the objects in a world.
#pragma once

#include <cstdint>

namespace meniscus {

/// Names an object in one world. Opaque: a create call returns it. A stale or foreign id is an error.
template <class Tag>
struct Id {
  uint32_t index = 0xffffffff;  ///< its place among the objects of its kind
  uint32_t generation = 0;      ///< tells it from those that had its place before

  friend bool operator==(Id, Id) = default;
};

using FluidId = Id<struct FluidTag>;            ///< of a fluid or a granular material
using ShapeId = Id<struct ShapeTag>;            ///< of a fixed solid
using BodyId = Id<struct BodyTag>;              ///< of a rigid body
using JointId = Id<struct JointTag>;            ///< of a joint
using ClothId = Id<struct ClothTag>;            ///< of a piece of cloth
using RopeId = Id<struct RopeTag>;              ///< of a rope or rod
using AttachmentId = Id<struct AttachmentTag>;  ///< of an attachment
using EmitterId = Id<struct EmitterTag>;        ///< of an emitter
using SinkId = Id<struct SinkTag>;              ///< of a sink
using ProbeId = Id<struct ProbeTag>;            ///< of a probe
using ForceFieldId = Id<struct ForceFieldTag>;  ///< of a force field

/// Particles are numbered from 0 in the order of their creation. A number is never used again.
using ParticleId = uint64_t;

}  // namespace meniscus
