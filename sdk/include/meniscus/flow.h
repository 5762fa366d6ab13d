// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters add particles to a running world, and sinks remove them. Units as in defs.h.
#pragma once

#include <meniscus/defs.h>

#include <limits>

namespace meniscus {

// ---- emitters ----

/// A disc in the plane y = 0 of its frame, about the origin. Particles leave along y.
struct DiscOpening {
  float radius = 0.1f;  ///< m
};

/// A rectangle in the plane y = 0 of its frame, about the origin. Particles leave along y.
struct RectangleOpening {
  float width = 0.2f;  ///< m, along x
  float depth = 0.2f;  ///< m, along z
};

/// The surface of any triangle mesh. Particles leave each triangle along its outward normal.
struct MeshOpening {
  std::string file;    ///< its path
  float scale = 1.0f;  ///< metres a file unit; a factor if the file states its unit, as FBX does
  /// In place of the file, which is then a name: vertices in units of `scale`, three of them a triangle.
  std::vector<Vec3> vertices{};
  std::vector<uint32_t> triangles{};  ///< three vertices each
};

/// Where particles leave an emitter.
using EmitterOpening = std::variant<DiscOpening, RectangleOpening, MeshOpening>;

/// What an emitter does where other fluid is in front of its opening.
enum class EmitterMode {
  free,     ///< a particle leaves if it has room, and fluid in front slows it down; less may leave
  imposed,  ///< a piston pushes the fluid in front away: see EmitterDef::mode
};

/// Makes particles in front of an opening, in layers that give the jet its rest density. Each particle is
/// placed where it has moved to under gravity between its emission and the end of the step. The emitted
/// volume is exact, however few particles fit across the opening. A jet stays together from three spacings
/// on. Over the first support radius a particle keeps its velocity, as if the pipe were still behind it.
///
/// A particle is not placed nearer than 0.7 spacings to another one or to a vertex of cloth. Nor is it placed
/// nearer than half a spacing to a solid that its fluid collides with, or beyond one. Without room one
/// particle waits in front of the opening, and less is emitted. Particles in its way get the velocity of the
/// jet. So an opening under water works, and a closed vessel fills up without a burst. Emitted fluid exerts
/// no recoil on a body.
struct EmitterDef {
  std::string name{};                      ///< what World::find_emitter takes
  FluidId fluid{};                         ///< or a granular material
  EmitterOpening opening = DiscOpening{};  ///< where particles leave
  Pose pose{};                             ///< of the opening, in the world; with a body, in the body's frame
  std::optional<BodyId> body{};  ///< carries the opening; its velocity is added to the emitted particles
  float speed = 1.0f;            ///< m/s, out of the opening, > 0
  /// m³/s, at most speed · area of the opening. 0 means that maximum. At half of the maximum or less, an even
  /// spray leaves in place of a jet.
  float rate = 0.0f;
  /// With `imposed`, layers of particles move through a duct behind the opening, as a piston of infinite mass
  /// and of the speed rate/area. A particle counts as emitted once its layer has passed the opening. The
  /// opening must be a disc or a rectangle without a body, on a solid or with air behind it. Within it the
  /// solid does not act on fluids. It starts at the end of the step in which `start` lies. It ends after
  /// whole layers. While the fluid ahead holds a particle too many in each support, as in a full vessel, the
  /// piston rests, and StepReport::emission_refused counts. Not with granular materials, nor with the solvers
  /// grid, pcisph, wcsph and dfsph.
  EmitterMode mode = EmitterMode::free;
  float start = 0.0f;                                   ///< s, of World::time, ≥ 0
  float stop = std::numeric_limits<float>::infinity();  ///< s, ≥ start
  std::optional<uint32_t> most_particles{};             ///< limit on the particles that it makes
};

// ---- sinks ----

/// Everything with normal · x < offset.
struct HalfSpaceRegion {
  Vec3 normal{0, 1, 0};  ///< of a length from 1e-6 to 1e18
  float offset = 0;      ///< m
};

/// Where a sink removes particles.
using SinkRegion = std::variant<BoxRegion, BallRegion, HalfSpaceRegion>;

/// Removes all particles of fluids and grains inside the region at the end of a step, or outside of it with
/// `outside`. Each removed particle counts for one sink alone.
struct SinkDef {
  std::string name{};                                      ///< what World::find_sink takes
  SinkRegion region = BoxRegion{{-1, -1, -1}, {1, 1, 1}};  ///< where particles are removed
  bool outside = false;                                    ///< removes those outside of the region instead
  Pose pose{};                   ///< of the region, in the world; with a body, in the body's frame
  std::optional<BodyId> body{};  ///< carries the region
};

// ---- read-outs ----

/// The number of particles that an emitter made or a sink removed.
struct FlowCount {
  uint32_t last_step = 0;  ///< in the last step
  uint64_t total = 0;      ///< since its creation
};

/// A particle that an emitter made or that a sink removed in the last step. One of the first two is valid.
struct FlowEvent {
  EmitterId emitter{};      ///< that made it; of an imposed emitter, once it has passed the opening
  SinkId sink{};            ///< that removed it
  ParticleId particle = 0;  ///< its id, which is gone if a sink removed it
};

}  // namespace meniscus
