// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "sdk/scene/scene.h"

namespace meniscus::viewer {

struct HeldBody {
  std::size_t index = 0;  ///< of BuiltScene::bodies; a dynamic one
  Vec3 point{0, 0, 0};    ///< m, in the body's frame
};

/// Places are from the point that was taken hold of, m.
struct HeldParticles {
  std::vector<ParticleId> ids;  ///< ascending; those that sinks have taken since are left out
  std::vector<Vec3> places;
};

/// Of a piece of cloth, or of a rope.
struct HeldVertices {
  bool of_rope = false;
  std::size_t index = 0;  ///< of BuiltScene::cloths or ropes
  std::vector<uint32_t> vertices;
  std::vector<Vec3> places;
};

/// What the mouse holds, and where it wants it.
struct Grab {
  std::variant<HeldBody, HeldParticles, HeldVertices> held;
  Vec3 target{0, 0, 0};  ///< m
};

/// Pulls what is held towards the target for the next step, of dt seconds, and bears its weight: a damped
/// spring, soft enough to give way to walls and to whatever else holds the thing. Returns where it is now.
Vec3 pull(const Grab& grab, BuiltScene& built, const Scene& scene, float dt);

}  // namespace meniscus::viewer
