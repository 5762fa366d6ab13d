// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What brings particles into a world while it runs, and what takes them out. Units as in defs.h.
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

/// The surface of any triangle mesh. Particles leave each triangle along its normal, out of the solid.
struct MeshOpening {
  std::string file;
  float scale =
      1.0f;  ///< metres a file unit; where the file says how long its unit is, as FBX does, a factor
};

using EmitterOpening = std::variant<DiscOpening, RectangleOpening, MeshOpening>;

/// Makes particles in front of an opening: in layers so far apart that the jet has its rest density, each
/// where it has got to since it left, under gravity, at the step's end. The volume that leaves is exact,
/// however few particles fit across the opening; a jet holds together from three spacings on.
/// Over the first support radius a particle keeps its velocity, as if the pipe were still behind it.
///
/// A particle gets no place nearer than 0.7 spacings to another one or to a vertex of cloth, nor nearer than
/// half a spacing to a solid that its fluid collides with, nor beyond one. Where there is no room, one
/// particle waits in front of the opening until there is, and less leaves meanwhile; particles in its way are
/// driven on as if they had left the opening themselves. So an opening under water works, and a closed vessel
/// fills up without a burst. What leaves does not push a body back.
struct EmitterDef {
  std::string name;
  FluidId fluid{};  ///< or a granular material
  EmitterOpening opening = DiscOpening{};
  Pose pose{};                   ///< of the opening, in the world; with a body, in the body's frame
  std::optional<BodyId> body{};  ///< carries the opening, and gives what leaves its own velocity on top
  float speed = 1.0f;            ///< m/s, out of the opening, > 0
  /// m³/s that leaves, at most speed · area of the opening; 0: as much as that. Half of it or less leaves as
  /// an even spray, in place of a jet.
  float rate = 0.0f;
  float start = 0.0f;                                   ///< s, of World::time, ≥ 0
  float stop = std::numeric_limits<float>::infinity();  ///< s, ≥ start
  std::optional<uint32_t> most_particles{};             ///< it makes no more than these
};

// ---- sinks ----

/// Everything with normal · x < offset.
struct HalfSpaceRegion {
  Vec3 normal{0, 1, 0};  ///< of a length from 1e-6 to 1e18
  float offset = 0;      ///< m
};

using SinkRegion = std::variant<BoxRegion, BallRegion, HalfSpaceRegion>;

/// Takes every particle, of fluid or grain, inside the region at the end of a step; or, with `outside`, every
/// one outside of it. A particle counts for one sink alone.
struct SinkDef {
  std::string name;
  SinkRegion region = BoxRegion{{-1, -1, -1}, {1, 1, 1}};
  bool outside = false;
  Pose pose{};                   ///< of the region, in the world; with a body, in the body's frame
  std::optional<BodyId> body{};  ///< carries the region
};

// ---- read-outs ----

/// Particles that an emitter made, or that a sink took.
struct FlowCount {
  uint32_t last_step = 0;
  uint64_t total = 0;
};

}  // namespace meniscus
