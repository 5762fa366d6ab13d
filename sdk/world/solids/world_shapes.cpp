// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes pieces, rigid parts and masses from each kind of geometry.
#include "sdk/world/solids/world_shapes.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>

#include "collision/film/film_surface.h"
#include "collision/film/tuning.h"
#include "collision/mesh/hull.h"
#include "sdk/world/solids/container_walls.h"
#include "sdk/world/solids/tuning.h"

namespace meniscus {

namespace {

using collision::RigidPart;
using collision::ShapeKind;
using collision::TriangleMesh;

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ErrorCode::invalid_argument, what + " " + why);
}

collision::Surface surface_of(const SurfaceDef& surface, const CollisionFilter& filter, float spacing) {
  return {surface.friction, surface.restitution,  surface.adhesion * spacing * spacing, surface.slip_length,
          filter,           surface.belt_velocity};
}

/// Adds a geometry's pieces to a solid, one overload a kind.
class SolidBuilder {
 public:
  SolidBuilder(SolidPieces& solid, const SurfaceDef& surface, const CollisionFilter& filter, SolidRole role,
               float density, const SolidContext& context)
      : solid_(solid),
        role_(role),
        density_(density),
        context_(context),
        surface_(surface_of(surface, filter, context.spacing)) {}

  void operator()(const PlaneGeometry& g) {
    if (role_ != SolidRole::fixed) refuse("a plane", "has no end and cannot be a body");
    const float l = length(g.normal);
    add_plane(g.normal / l, g.offset / l);
    RigidPart part;
    part.kind = RigidPart::Kind::plane;
    part.size = g.normal / l;
    part.offset = g.offset / l;
    solid_.parts.push_back(part);
  }
  void operator()(const BoxGeometry& g) {
    add(ShapeKind::box, g.half_extents, g.half_extents, RigidPart::Kind::box);
    add_film([&](float) { return collision::box_surface_mesh(g.half_extents); });
    weigh([&](double d) { return collision::box_mass(g.half_extents, d); });
  }
  void operator()(const SphereGeometry& g) {
    add(ShapeKind::sphere, {g.radius, 0, 0}, {g.radius, g.radius, g.radius}, RigidPart::Kind::sphere);
    add_film([&](float edge) { return collision::capsule_surface_mesh(g.radius, 0, edge); });
    weigh([&](double d) { return collision::sphere_mass(g.radius, d); });
  }
  void operator()(const CapsuleGeometry& g) {
    add(ShapeKind::capsule, {g.radius, g.half_height, 0}, {g.radius, g.radius + g.half_height, g.radius},
        RigidPart::Kind::capsule);
    add_film([&](float edge) { return collision::capsule_surface_mesh(g.radius, g.half_height, edge); });
    weigh([&](double d) { return collision::capsule_mass(g.radius, g.half_height, d); });
  }
  void operator()(const CylinderGeometry& g) {
    add(ShapeKind::cylinder, {g.radius, g.half_height, 0}, {g.radius, g.half_height, g.radius},
        RigidPart::Kind::cylinder);
    add_film([&](float edge) { return collision::cylinder_surface_mesh(g.radius, g.half_height, edge); });
    weigh([&](double d) { return collision::cylinder_mass(g.radius, g.half_height, d); });
  }
  void operator()(const MeshGeometry& g) {
    const bool falls = role_ == SolidRole::dynamic;
    const bool is_given = g.cell_size > 0;
    SolidMesh solid = context_.meshes.load(
        g, is_given ? g.cell_size : solids_tuning::field_cell * context_.spacing, falls, context_.files);
    const float cell_size = is_given ? g.cell_size : cell_for(collision::bounds(*solid.mesh));
    weigh([&](double d) {
      return collision::mesh_mass(*solid.mesh, d);
    });  // may throw, so it comes before a field is made
    add_field(*solid.mesh, cell_size, g.max_error);
    add_film([&](float) { return *solid.mesh; });
    if (!falls) add_part(solid.mesh, RigidPart::Kind::mesh);
    for (auto& hull : solid.hulls) add_part(std::move(hull), RigidPart::Kind::hull);
    if (solid.repair) solid_.repairs.push_back(std::move(*solid.repair));
  }
  void operator()(const HullGeometry& g) {
    const auto mesh = std::make_shared<const TriangleMesh>(collision::hull_mesh(g.points));
    const float cell_size = cell_for(collision::bounds(*mesh));
    add_field(*mesh, cell_size, 0);
    add_film([&](float) { return *mesh; });
    add_part(mesh, RigidPart::Kind::hull);
    weigh([&](double d) { return collision::mesh_mass(*mesh, d); });
  }
  void operator()(const HeightFieldGeometry& g) {
    if (role_ != SolidRole::fixed) refuse("a height field", "has no end below and cannot be a body");
    SolidPieces::Piece piece = new_piece(ShapeKind::height_field, {0, 0, 0});
    hold(piece,
         context_.engine.add_height_field(static_cast<uint32_t>(g.columns), static_cast<uint32_t>(g.rows),
                                          g.cell_size, g.heights),
         &Engine::remove_height_field);
    const float x = 0.5f * g.cell_size * static_cast<float>(g.columns - 1);
    const float z = 0.5f * g.cell_size * static_cast<float>(g.rows - 1);
    const float top = *std::max_element(g.heights.begin(), g.heights.end());
    // The solid extends downwards as far as a particle could fall in the longest run.
    piece.place.bounds = {{-x, -1e6f, -z}, {x, top, z}};
    solid_.pieces.push_back(piece);
    RigidPart part;
    part.kind = RigidPart::Kind::height_field;
    part.heights = g;
    solid_.parts.push_back(part);
  }
  void operator()(const ContainerGeometry& g) {
    if (role_ == SolidRole::dynamic)
      refuse("a container", "has walls without end and cannot be a dynamic body");
    const float half[3] = {g.half_extents.x, g.half_extents.y, g.half_extents.z};
    for (int face = 0; face < 6; ++face) add_wall(g, face, half[face / 2]);
    const std::vector<RigidPart> walls = container_walls(g);
    solid_.parts.insert(solid_.parts.end(), walls.begin(), walls.end());
  }
  void operator()(const CompoundGeometry& g) {
    for (const CompoundPart& part : g.parts) {
      const Pose outer = pose_;
      pose_ = outer * part.pose;
      std::visit(*this, part.geometry);
      pose_ = outer;
    }
  }

 private:
  /// Half a spacing, or wider cells around a large mesh, so that its field has a bounded number of nodes.
  float cell_for(const Aabb& box) const {
    const Vec3 size = box.upper - box.lower + 2 * Vec3{context_.reach, context_.reach, context_.reach};
    const double volume = double{size.x} * size.y * size.z;
    return std::max(solids_tuning::field_cell * context_.spacing,
                    static_cast<float>(std::cbrt(volume / solids_tuning::most_field_nodes)));
  }

  SolidPieces::Piece new_piece(ShapeKind kind, Vec3 size) const {
    SolidPieces::Piece piece;
    piece.shape.kind = kind;
    piece.shape.size = size;
    piece.shape.surface = surface_;
    piece.place.pose = pose_;
    return piece;
  }

  void add(ShapeKind kind, Vec3 size, Vec3 half, RigidPart::Kind part_kind) {
    SolidPieces::Piece piece = new_piece(kind, size);
    piece.place.bounds = {-half, half};
    solid_.pieces.push_back(piece);
    RigidPart part;
    part.kind = part_kind;
    part.pose = pose_;
    part.size = size;
    solid_.parts.push_back(part);
  }

  /// The table is removed from the engine with the last copy of the piece.
  void hold(SolidPieces::Piece& piece, uint32_t table, void (Engine::*remove)(uint32_t)) const {
    Engine* const engine = &context_.engine;
    piece.shape.table = table;
    piece.field = std::shared_ptr<const void>(
        nullptr, [engine, table, remove](const void*) { (engine->*remove)(table); });
  }

  void add_field(const TriangleMesh& mesh, float cell_size, float max_error) {
    SolidPieces::Piece piece = new_piece(ShapeKind::sdf, {0, 0, 0});
    hold(piece, context_.engine.add_sdf(mesh, cell_size, max_error, context_.reach), &Engine::remove_sdf);
    piece.place.bounds = collision::bounds(mesh);
    solid_.pieces.push_back(piece);
  }

  /// Gives the last piece of a body its surface.
  template <class Surface>
  void add_film(const Surface& surface) {
    if (role_ == SolidRole::fixed) return;
    const float edge = collision::film_tuning::edge * context_.spacing;
    solid_.pieces.back().film =
        std::make_shared<const TriangleMesh>(collision::film_mesh(surface(edge), edge));
  }

  void add_part(std::shared_ptr<const TriangleMesh> mesh, RigidPart::Kind kind) {
    RigidPart part;
    part.kind = kind;
    part.pose = pose_;
    part.mesh = std::move(mesh);
    solid_.parts.push_back(part);
  }

  void add_plane(Vec3 normal, float offset) {
    SolidPieces::Piece piece = new_piece(ShapeKind::plane, normal);
    piece.place.normal = normal;
    piece.place.offset = offset;
    solid_.pieces.push_back(piece);
  }

  void add_wall(const ContainerGeometry& g, int face, float half) {
    const int axis = face / 2;
    const auto first = static_cast<uint32_t>(solid_.openings.size());
    for (const Opening& opening : g.openings) {
      if (static_cast<int>(opening.face) != face) continue;
      if (!opening.region) return;  // the wall is missing
      solid_.openings.push_back({without_depth(*opening.region, axis)});
    }
    const float inwards = face % 2 == 0 ? 1.0f : -1.0f;
    add_plane({axis == 0 ? inwards : 0, axis == 1 ? inwards : 0, axis == 2 ? inwards : 0}, -half);
    solid_.pieces.back().shape.first_opening = first;
    solid_.pieces.back().shape.opening_count = static_cast<uint32_t>(solid_.openings.size()) - first;
  }

  static Aabb without_depth(Aabb box, int axis) {
    constexpr float everywhere = 1e30f;
    (axis == 0 ? box.lower.x : axis == 1 ? box.lower.y : box.lower.z) = -everywhere;
    (axis == 0 ? box.upper.x : axis == 1 ? box.upper.y : box.upper.z) = everywhere;
    return box;
  }

  template <class Mass>
  void weigh(const Mass& mass) {
    if (role_ == SolidRole::dynamic) solid_.masses.push_back({mass(density_), pose_});
  }

  SolidPieces& solid_;
  SolidRole role_;
  double density_;
  const SolidContext& context_;
  collision::Surface surface_;
  Pose pose_{};
};

}  // namespace

SolidPieces make_solid(const Geometry& geometry, const SurfaceDef& surface, const CollisionFilter& filter,
                       SolidRole role, float density, const SolidContext& context) {
  SolidPieces solid;
  SolidBuilder build(solid, surface, filter, role, density, context);
  std::visit(build, geometry);
  return solid;
}

void set_surfaces(SolidPieces& solid, const SurfaceDef& surface, float spacing) {
  for (SolidPieces::Piece& piece : solid.pieces)
    piece.shape.surface = surface_of(surface, piece.shape.surface.filter, spacing);
}

collision::Shape placed(const SolidPieces::Piece& piece, const Pose& pose) {
  collision::Shape shape = piece.shape;
  carry(piece.place, {pose, pose}, shape);
  if (shape.kind == collision::ShapeKind::height_field) {
    // The box is so deep that, measured from its middle, floats miss the top by centimetres.
    Aabb near_top = piece.place.bounds;
    near_top.lower.y = near_top.upper.y - (near_top.upper.x + near_top.upper.z);
    const Aabb box = collision::world_box(shape.pose, near_top);
    shape.bounds = {min(shape.bounds.lower, box.lower), max(shape.bounds.upper, box.upper)};
  }
  return shape;
}

collision::RigidSolid rigid_solid(const SolidPieces& solid, const Pose& pose, const SurfaceDef& surface,
                                  const CollisionFilter& filter) {
  return {solid.parts, pose, surface.solid_friction, surface.solid_restitution, filter};
}

}  // namespace meniscus
