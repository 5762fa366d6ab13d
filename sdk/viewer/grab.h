// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the mouse holds, and how it is pulled.
#pragma once

#include <variant>
#include <vector>

#include <meniscus/scene.h>

namespace meniscus::viewer {

struct HeldBody {
  std::size_t index = 0;  ///< index in BuiltScene::bodies; a dynamic one
  Vec3 point{0, 0, 0};    ///< m, in the body's frame
};

/// Held particles; their offsets are relative to the point where they were grabbed, m.
struct HeldParticles {
  std::vector<ParticleId> ids;  ///< ascending; particles that sinks have removed since are skipped
  std::vector<Vec3> places;
};

/// Held vertices of a piece of cloth or of a rope.
struct HeldVertices {
  bool of_rope = false;
  std::size_t index = 0;  ///< index in BuiltScene::cloths or ropes
  std::vector<uint32_t> vertices;
  std::vector<Vec3> places;
};

/// What the mouse holds, and its target.
struct Grab {
  std::variant<HeldBody, HeldParticles, HeldVertices> held;
  Vec3 target{0, 0, 0};  ///< m
};

/// Pulls the held object towards the target in the next step, of dt seconds, and carries its weight. The pull
/// is a damped spring, soft enough to yield to walls and other constraints. Returns the present place of the
/// held point.
Vec3 pull(const Grab& grab, BuiltScene& built, const Scene& scene, float dt);

}  // namespace meniscus::viewer
