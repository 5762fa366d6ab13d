// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Expands the copies of a scene's bodies.
#include <meniscus/scene.h>
#include "pbd/math/vec.h"

namespace meniscus {
namespace {

BodyDef moved(BodyDef body, Vec3 offset) {
  body.pose.position += offset;
  for (Keyframe& keyframe : body.keyframes) keyframe.pose.position += offset;
  return body;
}

}  // namespace

std::vector<BodyDef> copies_of(const SceneBody& body) {
  if (!body.copies) return {body.def};
  const auto& [count, step] = *body.copies;
  std::vector<BodyDef> copies;
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        const Vec3 offset{float(x) * step.x, float(y) * step.y, float(z) * step.z};
        copies.push_back(moved(body.def, offset));
        copies.back().name.append("_").append(std::to_string(copies.size() - 1));
      }
    }
  }
  return copies;
}

std::vector<BodyDef> bodies_of(const Scene& scene) {
  std::vector<BodyDef> bodies;
  for (const SceneBody& body : scene.bodies) {
    for (BodyDef& copy : copies_of(body)) bodies.push_back(std::move(copy));
  }
  return bodies;
}

}  // namespace meniscus
