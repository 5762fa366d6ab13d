// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace meniscus {

/// Names a thing in one world. Opaque: it comes from a create call. A stale or foreign id is refused, not
/// followed.
template <class Tag>
struct Id {
  uint32_t index = 0xffffffff;
  uint32_t generation = 0;

  friend bool operator==(Id, Id) = default;
};

using FluidId = Id<struct FluidTag>;  ///< what particles are made of: a fluid, or a granular material
using ShapeId = Id<struct ShapeTag>;
using BodyId = Id<struct BodyTag>;
using JointId = Id<struct JointTag>;
using ClothId = Id<struct ClothTag>;
using RopeId = Id<struct RopeTag>;
using AttachmentId = Id<struct AttachmentTag>;
using EmitterId = Id<struct EmitterTag>;
using SinkId = Id<struct SinkTag>;
using ProbeId = Id<struct ProbeTag>;

/// Particles are numbered from 0 in the order of their making, and a number is never used again.
using ParticleId = uint64_t;

}  // namespace meniscus
