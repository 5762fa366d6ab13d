// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The forms that a geometry takes for particles, for Bullet and for masses.
#pragma once

#include <meniscus/bodies.h>

#include <memory>
#include <vector>

#include "collision/body/proxy.h"
#include "collision/mesh/mass_properties.h"
#include "collision/rigid/rigid_world.h"
#include "sdk/engine/engine.h"
#include "sdk/world/solids/solid_mesh.h"

namespace meniscus {

/// The forms of a geometry: pieces for the particles, parts for Bullet, and masses; all in the geometry's
/// frame.
struct SolidPieces {
  struct Piece {
    collision::Shape shape;  ///< kind, size, table, surface, openings; first_opening counts within `openings`
    collision::CarriedShape place;                        ///< pose and extent
    std::shared_ptr<const collision::TriangleMesh> film;  ///< of a body's piece: its surface, see FilmPart
    std::shared_ptr<const void> field;  ///< keeps its table in the engine, for all copies of the piece
  };
  std::vector<Piece> pieces;
  std::vector<collision::PlaneOpening> openings;
  std::vector<collision::RigidPart> parts;
  std::vector<collision::PlacedMass> masses;  ///< of a dynamic body alone
  std::vector<MeshRepair> repairs;
};

/// The role of a solid.
enum class SolidRole { fixed, kinematic, dynamic };

struct SolidContext {
  Engine& engine;
  SolidMeshes& meshes;
  float spacing, reach;  ///< m: they set a mesh field's cell size and margin
  const FileReader& files;
};

/// Builds the pieces, with their fields in the engine, which must outlive them. The masses of a dynamic body
/// have this density (kg/m³).
SolidPieces make_solid(const Geometry& geometry, const SurfaceDef& surface, const CollisionFilter& filter,
                       SolidRole role, float density, const SolidContext& context);
/// Gives all pieces another surface, and leaves their filter.
void set_surfaces(SolidPieces& solid, const SurfaceDef& surface, float spacing);

/// The piece at its pose.
collision::Shape placed(const SolidPieces::Piece& piece, const Pose& pose);
/// The solid for Bullet.
collision::RigidSolid rigid_solid(const SolidPieces& solid, const Pose& pose, const SurfaceDef& surface,
                                  const CollisionFilter& filter);

}  // namespace meniscus
