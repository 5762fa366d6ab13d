// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The geometric part of scene_fields.h: placements, solids and regions.
#pragma once

#include <meniscus/defs.h>

#include <array>
#include <limits>
#include <optional>
#include <string>

#include "pbd/math/direction.h"
#include "sdk/scene/scene_field_rule.h"

namespace meniscus {

/// An enumerator and its word in a scene file.
template <class E>
struct Named {
  const char* name;
  E value;
};

constexpr auto names_of(Face) {
  return std::array{Named{"x_low", Face::x_low}, Named{"x_high", Face::x_high},
                    Named{"y_low", Face::y_low}, Named{"y_high", Face::y_high},
                    Named{"z_low", Face::z_low}, Named{"z_high", Face::z_high}};
}

constexpr bool ordered(Vec3 lower, Vec3 upper) {
  return lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z;
}

/// The readable form of a rotation.
struct AxisAngle {
  Vec3 axis{0, 1, 0};
  float degrees = 0;
};

template <class V>
void fields(V& v, AxisAngle& d) {
  v("axis", d.axis, required(any_value), "",
    "direction to turn about, by the right hand; of a length from 1e-6 to 1e18");
  v("degrees", d.degrees, required(any_value), "degrees", "how far to turn");
  v.check(pbd::is_direction(d.axis), "axis must be of a length from 1e-6 to 1e18");
}

template <class V>
void fields(V& v, Pose& d) {
  v("position", d.position, any_value, "m", "where the origin of the local frame sits");
  v("rotation", d.rotation, any_value, "", "axis and angle, or a quaternion [x, y, z, w]");
}

template <class V>
void fields(V& v, Aabb& d) {
  v("lower", d.lower, required(any_value), "m", "least corner");
  v("upper", d.upper, required(any_value), "m", "greatest corner");
  v.check(ordered(d.lower, d.upper), "lower must not be above upper in any component");
}

template <class V>
void fields(V& v, PlaneGeometry& d) {
  v("normal", d.normal, any_value, "", "points out of the solid; of a length from 1e-6 to 1e18");
  v("offset", d.offset, any_value, "m", "distance of the plane from the origin, along the normal");
  v.check(pbd::is_direction(d.normal), "normal must be of a length from 1e-6 to 1e18");
}

template <class V>
void fields(V& v, BoxGeometry& d) {
  v("half_extents", d.half_extents, positive, "m", "half of the edges");
}

template <class V>
void fields(V& v, Opening& d) {
  std::optional<Vec3> lower, upper;
  v("face", d.face, any_value, "", "the face with the hole");
  v("lower", lower, any_value, "m",
    "least corner of the hole, in the container's frame; left out, the face is open");
  v("upper", upper, any_value, "m", "greatest corner of the hole");
  v.check(lower.has_value() == upper.has_value(), "lower and upper must come together");
  if (!lower || !upper) return;
  v.check(ordered(*lower, *upper), "lower must not be above upper in any component");
  d.region = Aabb{*lower, *upper};
}

template <class V>
void fields(V& v, ContainerGeometry& d) {
  v("half_extents", d.half_extents, positive, "m", "half of the inside's edges");
  v("openings", d.openings, any_value, "", "holes in the faces");
}

template <class V>
void fields(V& v, SphereGeometry& d) {
  v("radius", d.radius, positive, "m", "radius");
}

template <class V>
void fields(V& v, CapsuleGeometry& d) {
  v("radius", d.radius, positive, "m", "radius");
  v("half_height", d.half_height, not_negative, "m", "half of the distance between the two centres");
}

template <class V>
void fields(V& v, CylinderGeometry& d) {
  v("radius", d.radius, positive, "m", "radius");
  v("half_height", d.half_height, positive, "m", "half of the length");
}

inline constexpr const char* mesh_file_text =
    "mesh file, from the scene's folder, or glmark2:NAME for a model of Debian's glmark2-data";

template <class V>
void fields(V& v, MeshGeometry& d) {
  v("file", d.file, required(any_value), "", mesh_file_text);
  v("scale", d.scale, positive, "m", "length of a unit of the file");
  v("cell_size", d.cell_size, not_negative, "m", "of the distance field; 0 is half of the particle spacing");
  v("max_error", d.max_error, not_negative, "m",
    "when above 0, the distance field is as fine as it takes to be off by no more");
}

template <class V>
void fields(V& v, HullGeometry& d) {
  std::optional<std::string> file;  // its vertices are added by resolve_meshes()
  float scale = 1;
  v("points", d.points, any_value, "m", "what the hull holds; without a file, at least 4, not in a plane");
  v("file", file, any_value, "", "mesh whose vertices the hull holds too; a file as that of a mesh");
  v("scale", scale, positive, "m", "length of a unit of the file");
  v.check(file || scale == 1, "scale is the file's; points are in metres");
  v.check(file || d.points.size() >= 4,
          "a hull needs at least 4 points, not " + std::to_string(d.points.size()) + ", or a file");
}

template <class V>
void fields(V& v, HeightFieldGeometry& d) {
  v("columns", d.columns, required(between(2, 32768)), "", "samples along x");
  v("rows", d.rows, required(between(2, 32768)), "", "samples along z");
  v("cell_size", d.cell_size, positive, "m", "distance between samples");
  v("heights", d.heights, required(with_items(4)), "m", "columns · rows heights, x fastest");
  v.check(d.heights.size() == std::size_t(d.columns) * std::size_t(d.rows),
          "heights must hold columns · rows = " + std::to_string(d.columns) + " · " + std::to_string(d.rows) +
              " numbers, not " + std::to_string(d.heights.size()));
}

/// Solids with an outside all around.
template <class V>
void solid_choices(V& v, Geometry& g) {
  v.choice("box", BoxGeometry{}, g, "a solid box");
  v.choice("sphere", SphereGeometry{}, g, "a solid ball");
  v.choice("capsule", CapsuleGeometry{}, g, "a cylinder along y with round ends");
  v.choice("cylinder", CylinderGeometry{}, g, "a cylinder along y");
  v.choice("mesh", MeshGeometry{}, g, "the inside of a closed triangle mesh");
  v.choice("hull", HullGeometry{}, g, "the convex hull of points");
}

/// What a part of a compound may be.
struct PartGeometry {
  Geometry geometry;
};

template <class V>
void choices(V& v, PartGeometry& g) {
  solid_choices(v, g.geometry);
}

template <class V>
void fields(V& v, CompoundPart& d) {
  PartGeometry part{d.geometry};
  v("geometry", part, required(any_value), "", "what it is");
  v("pose", d.pose, any_value, "", "placement in the compound's frame");
  d.geometry = part.geometry;
}

template <class V>
void fields(V& v, CompoundGeometry& d) {
  v("parts", d.parts, required(not_empty), "", "the solids that it is made of; they may overlap");
}

template <class V>
void choices(V& v, Geometry& g) {
  v.choice("plane", PlaneGeometry{}, g, "everything below a plane is solid");
  v.choice("container", ContainerGeometry{}, g, "a box seen from inside: its faces hold the fluid in");
  v.choice("height_field", HeightFieldGeometry{}, g, "heights over a grid in x and z, centred; solid below");
  solid_choices(v, g);
  v.choice("compound", CompoundGeometry{}, g, "several solids as one");
}

/// How a solid's surface treats what touches it: keys of the solid itself.
template <class V>
void surface_fields(V& v, SurfaceDef& d) {
  v("friction", d.friction, not_negative, "", "Coulomb's coefficient for particles");
  v("restitution", d.restitution, between(0, 1), "",
    "share of the normal speed that a particle's bounce keeps");
  v("adhesion", d.adhesion, not_negative, "Pa", "pull on a wet layer of particles, per area");
  v("solid_friction", d.solid_friction, not_negative, "",
    "Coulomb's coefficient for solids; of two that touch, the geometric mean counts");
  v("solid_restitution", d.solid_restitution, between(0, 1), "",
    "share of the normal speed that a bounce off a solid keeps");
}

/// What collides with what: keys of the fluid or solid itself.
template <class V>
void filter_fields(V& v, CollisionFilter& d) {
  constexpr FieldRule bits = between(0, std::numeric_limits<uint32_t>::max());
  v("groups", d.groups, bits, "", "what it is, as the sum of powers of 2");
  v("mask", d.mask, bits, "",
    "which groups it collides with, as the sum of powers of 2; two things collide where each one's group is "
    "in the other's mask");
}

template <class V>
void fields(V& v, ShapeDef& d) {
  v("name", d.name, required(not_empty), "", "what probes call this shape");
  v("geometry", d.geometry, required(any_value), "", "what it is");
  v("pose", d.pose, any_value, "", "placement of the geometry");
  surface_fields(v, d.surface);
  filter_fields(v, d.filter);
}

template <class V>
void fields(V& v, BoxRegion& d) {
  v("lower", d.lower, any_value, "m", "least corner, before the pose");
  v("upper", d.upper, any_value, "m", "greatest corner, before the pose");
  v.check(d.lower.x < d.upper.x && d.lower.y < d.upper.y && d.lower.z < d.upper.z,
          "lower must be below upper in every component");
}

template <class V>
void fields(V& v, BallRegion& d) {
  v("radius", d.radius, positive, "m", "radius");
}

template <class V>
void fields(V& v, MeshRegion& d) {
  v("file", d.file, required(any_value), "", mesh_file_text);
  v("scale", d.scale, positive, "m", "length of a unit of the file");
}

template <class V>
void choices(V& v, Region& r) {
  v.choice("box", BoxRegion{}, r, "a box");
  v.choice("ball", BallRegion{}, r, "a ball about the origin");
  v.choice("mesh", MeshRegion{}, r, "the inside of a closed triangle mesh");
}

}  // namespace meniscus
