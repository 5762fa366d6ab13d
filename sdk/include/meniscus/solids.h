// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Geometries and surfaces of solids, and fixed shapes. Units as in defs.h.
#pragma once

#include <meniscus/types.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

/// Everything with normal · x < offset is solid.
struct PlaneGeometry {
  Vec3 normal{0, 1, 0};  ///< of a length from 1e-6 to 1e18
  float offset = 0;      ///< m
};

/// A solid box about the origin.
struct BoxGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m
};

/// A face of a box, by its axis and side.
enum class Face { x_low, x_high, y_low, y_high, z_low, z_high };

/// A hole in a face of a container, through which fluid leaves. A particle that has left is outside of the
/// container for good. Without a region the whole face is open. The walls around it then continue without
/// end, as in a tall vessel or a channel.
struct Opening {
  Face face = Face::y_high;      ///< the face with the hole
  std::optional<Aabb> region{};  ///< in the container's frame; the extent along the face's normal is ignored
};

/// A box that holds fluid and bodies inside its six faces. Outside of them is solid: for fluid without end,
/// for bodies up to the largest half extent. Use a CollisionFilter for objects beside a container.
struct ContainerGeometry {
  Vec3 half_extents{0.5f, 0.5f, 0.5f};  ///< m, of the inside
  std::vector<Opening> openings{};      ///< at least one face is left
};

/// A solid ball about the origin.
struct SphereGeometry {
  float radius = 0.5f;  ///< m
};

/// Along y; half_height is half of the distance between the two centres.
struct CapsuleGeometry {
  float radius = 0.5f;       ///< m
  float half_height = 0.5f;  ///< m
};

/// Along y.
struct CylinderGeometry {
  float radius = 0.5f;       ///< m
  float half_height = 0.5f;  ///< m
};

/// A closed surface from a mesh file (OBJ, PLY, STL, glTF, FBX, DAE or 3DS), as a signed distance field. The
/// winding number closes holes. The mesh of a dynamic body must have none, unless `repair` is set. For other
/// solids, rays and overlaps, convex parts stand for the mesh of a dynamic body.
struct MeshGeometry {
  std::string file;        ///< its path
  float scale = 1.0f;      ///< metres a file unit; a factor if the file states its unit, as FBX does
  float cell_size = 0.0f;  ///< of the field, m; 0: half a particle_spacing, wider around large meshes
  float max_error = 0.0f;  ///< m; if > 0, the field is refined until its error is no larger
  /// Rebuilds the surface where the mesh has open edges, edges of more than two faces, or faces that cross.
  /// World::mesh_repairs says how well both agree.
  bool repair = false;
  int convex_parts = 32;  ///< of a dynamic body, at most, 1 to 256; 1: the convex hull
  /// In place of the file, which is then a name: vertices in units of `scale`, three of them a triangle.
  std::vector<Vec3> vertices{};
  std::vector<uint32_t> triangles{};  ///< three vertices each
};

/// The convex hull of points. For solids, rays and overlaps it has at most 200 of them, the outermost.
struct HullGeometry {
  std::vector<Vec3> points;  ///< m, at least 4, not in a plane
};

/// Several solids as one. If parts overlap, the mass of both counts.
struct CompoundGeometry {
  std::vector<struct CompoundPart> parts;  ///< the solids
};

/// Heights over a regular grid in x and z, centred at the origin. It is solid below.
struct HeightFieldGeometry {
  int columns = 0;               ///< samples along x, 2 to 32,768
  int rows = 0;                  ///< samples along z, 2 to 32,768
  float cell_size = 0.1f;        ///< m
  std::vector<float> heights{};  ///< m, columns · rows of them, x fastest
};

/// The shape of a solid.
using Geometry =
    std::variant<PlaneGeometry, BoxGeometry, ContainerGeometry, SphereGeometry, CapsuleGeometry,
                 CylinderGeometry, MeshGeometry, HeightFieldGeometry, HullGeometry, CompoundGeometry>;

/// One of the solids of a compound.
struct CompoundPart {
  Geometry geometry = BoxGeometry{};  ///< no plane, container, height field or compound
  Pose pose{};                        ///< in the frame of the compound
};

/// Contact parameters of a solid. Between two solids the geometric mean counts.
struct SurfaceDef {
  float friction = 0.0f;     ///< Coulomb's μ for particles, ≥ 0
  float restitution = 0.0f;  ///< for particles, 0 to 1
  float adhesion = 0.0f;     ///< Pa, ≥ 0: pull on a wet layer of particles
  /// m, ≥ 0: how viscous fluid slips along the surface. Its velocity, continued linearly, is that of the
  /// solid this deep behind the surface. 0: no slip; infinite: free.
  float slip_length = std::numeric_limits<float>::infinity();
  float solid_friction = 0.5f;     ///< Coulomb's μ for solids, ≥ 0
  float solid_restitution = 0.0f;  ///< for solids, 0 to 1
  /// m/s, in the world's frame, of fixed shapes alone: the surface moves along itself like a belt, while the
  /// shape stays. It carries particles and cloth by friction, and viscous fluid by `slip_length`. The part
  /// along the normal does not count. Bodies do not feel it.
  Vec3 belt_velocity{0, 0, 0};
};

/// A solid that does not move.
struct ShapeDef {
  std::string name{};                   ///< what World::find_shape takes
  Geometry geometry = PlaneGeometry{};  ///< what it is
  Pose pose{};                          ///< of the geometry's frame
  SurfaceDef surface{};                 ///< its contacts with particles, cloth and bodies
  CollisionFilter filter{};             ///< what collides with it
};

}  // namespace meniscus
