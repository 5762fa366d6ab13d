// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What queries of a world take and return. Units as in defs.h.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace meniscus {

/// What a query considers.
struct QueryTargets {
  bool solids = true;     ///< fixed shapes and bodies
  bool particles = true;  ///< of fluids and grains
  bool cloth = true;      ///< pieces of cloth, as surfaces without thickness
  bool ropes = true;      ///< ropes and rods, with their radius
};

/// The first hit of a ray.
struct RayHit {
  BodyId body{};                         ///< valid if it is a body
  ShapeId shape{};                       ///< valid if it is a fixed shape
  std::optional<ParticleId> particle{};  ///< its id, if it is a particle
  Vec3 point{0, 0, 0};                   ///< m
  Vec3 normal{0, 0, 0};                  ///< unit, against the ray
  float distance = 0;                    ///< m along the ray
  ClothId cloth{};                       ///< valid if it is cloth
  RopeId rope{};                         ///< valid if it is a rope or rod
  uint32_t element = 0;                  ///< of cloth the triangle, of a rope the segment; by number
};

/// The nearest place on a surface: see World::nearest.
struct NearestPoint {
  BodyId body{};                         ///< valid if it is a body
  ShapeId shape{};                       ///< valid if it is a fixed shape
  std::optional<ParticleId> particle{};  ///< its id, if it is a particle
  ClothId cloth{};                       ///< valid if it is cloth
  RopeId rope{};                         ///< valid if it is a rope or rod
  uint32_t element = 0;                  ///< of cloth the triangle, of a rope the segment; by number
  Vec3 point{0, 0, 0};                   ///< m, on the surface
  Vec3 normal{0, 0, 0};                  ///< unit, out of the surface; of cloth towards the given point
  float distance = 0;                    ///< m, from the given point; negative inside
};

/// What a volume of a query overlaps.
struct Overlaps {
  std::vector<BodyId> bodies;         ///< that overlap it
  std::vector<ShapeId> shapes;        ///< fixed shapes that overlap it
  std::vector<ParticleId> particles;  ///< those with their centres inside
  std::vector<ClothId> cloths;        ///< pieces of which a triangle overlaps it
  std::vector<RopeId> ropes;          ///< of which a segment overlaps it, with its radius
};

/// The fluid at a point, as weighted means over the particles within a support radius of it.
struct FluidSample {
  float density = 0;       ///< kg/m³; less beside walls and the surface; 0 without particles
  Vec3 velocity{0, 0, 0};  ///< m/s; 0 without particles
  uint32_t particles = 0;  ///< within the support radius
};

}  // namespace meniscus
