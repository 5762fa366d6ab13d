// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids: their geometry and their surface.
#pragma once

#include <meniscus/defs.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "sdk/fields/names.h"
#include "sdk/fields/values.h"

namespace meniscus {

constexpr auto names_of(Face) {
  return std::array{Named{"x_low", Face::x_low}, Named{"x_high", Face::x_high},
                    Named{"y_low", Face::y_low}, Named{"y_high", Face::y_high},
                    Named{"z_low", Face::z_low}, Named{"z_high", Face::z_high}};
}

template <class V>
void fields(V& v, PlaneGeometry& d) {
  v("normal", d.normal, any_value, "", "points out of the solid; of a length from 1e-6 to 1e18");
  v("offset", d.offset, any_value, "m", "distance of the plane from the origin, along the normal");
  check_direction(v, "normal", d.normal);
}

template <class V>
void fields(V& v, BoxGeometry& d) {
  v("half_extents", d.half_extents, positive, "m", "half of the edges");
}

template <class V>
void fields(V& v, Opening& d) {
  v("face", d.face, any_value, "", "the face with the hole");
  if constexpr (OfMembers<V>) {
    flat(v, "region", d.region);
  } else {
    std::optional<Vec3> lower, upper;
    v("lower", lower, key_only(any_value), "m",
      "least corner of the hole, in the container's frame; left out, the face is open");
    v("upper", upper, key_only(any_value), "m", "greatest corner of the hole");
    v.check(lower.has_value() == upper.has_value(), "lower and upper must come together");
    if (!lower || !upper) return;
    d.region = Aabb{*lower, *upper};
    check_corners(v, *lower, *upper);
  }
}

/// Whether a face is left. An opening without a region removes its face.
inline bool has_a_face(const std::vector<Opening>& openings) {
  std::array<bool, names_of(Face{}).size()> is_open{};
  for (const Opening& o : openings) {
    if (!o.region) is_open[static_cast<std::size_t>(o.face)] = true;
  }
  return std::find(is_open.begin(), is_open.end(), false) != is_open.end();
}

template <class V>
void fields(V& v, ContainerGeometry& d) {
  v("half_extents", d.half_extents, positive, "m", "half of the inside's edges");
  v("openings", d.openings, any_value, "", "holes in the faces");
  v.check(has_a_face(d.openings), "openings must leave a face", "openings", d.openings);
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

/// The mesh of a file, or triangles that stand in the definition. Whether these fit is found where they are
/// used.
template <class V, class Def>
void mesh_fields(V& v, Def& d) {
  constexpr FieldRule numbers = between(0, std::numeric_limits<uint32_t>::max());
  v("file", d.file, any_value, "", mesh_file_text);
  v("scale", d.scale, positive, "m", "length of a unit of the mesh");
  v("vertices", d.vertices, any_value, "", "in place of a file, in units of the scale");
  v("triangles", d.triangles, numbers, "", "three numbers of vertices each, counted from 0");
}

template <class V>
void fields(V& v, MeshGeometry& d) {
  mesh_fields(v, d);
  v("cell_size", d.cell_size, not_negative, "m", "of the distance field; 0 is half of the particle spacing");
  v("max_error", d.max_error, not_negative, "m",
    "when above 0, the distance field is as fine as it takes to be off by no more");
  v("repair", d.repair, any_value, "", "rebuild the surface where it has holes or crosses itself");
  v("convex_parts", d.convex_parts, between(1, 256), "",
    "most convex parts that stand for a dynamic body against solids; 1 is its hull");
}

template <class V>
void fields(V& v, HullGeometry& d) {
  std::optional<std::string> file;  // its vertices are added by resolve_meshes()
  float scale = 1;
  v("points", d.points, any_value, "m", "what the hull holds; without a file, at least 4, not in a plane");
  v("file", file, key_only(any_value), "",
    "mesh whose vertices the hull holds too; a file as that of a mesh");
  v("scale", scale, key_only(positive), "m", "length of a unit of the file");
  v.check(file || scale == 1, "scale is the file's; points are in metres");
  v.check(file || d.points.size() >= 4,
          "a hull needs at least 4 points, not " + std::to_string(d.points.size()) +
              (OfMembers<V> ? "" : ", or a file"),
          "points", d.points);
}

template <class V>
void fields(V& v, HeightFieldGeometry& d) {
  v("columns", d.columns, required(between(2, 32768)), "", "samples along x");
  v("rows", d.rows, required(between(2, 32768)), "", "samples along z");
  v("cell_size", d.cell_size, positive, "m", "distance between samples");
  v("heights", d.heights, required(with_items(4)), "m", "columns · rows heights, x fastest");
  v.check(d.heights.size() == std::size_t(d.columns) * std::size_t(d.rows),
          "heights must hold columns · rows = " + std::to_string(d.columns) + " · " + std::to_string(d.rows) +
              " numbers, not " + std::to_string(d.heights.size()),
          "heights", d.heights);
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
  Geometry& geometry;
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

inline constexpr const char* slip_length_text =
    "depth behind the surface at which a viscous fluid would rest; 0 is no slip, left out it slips freely";

/// How a solid's surface treats what touches it: keys of the solid itself.
template <class V>
void fields(V& v, SurfaceDef& d) {
  v("friction", d.friction, not_negative, "", "Coulomb's coefficient for particles");
  v("restitution", d.restitution, between(0, 1), "",
    "share of the normal speed that a particle's bounce keeps");
  v("adhesion", d.adhesion, not_negative, "Pa", "pull on a wet layer of particles, per area");
  v("slip_length", d.slip_length, or_infinity(not_negative), "m", slip_length_text);
  v("solid_friction", d.solid_friction, not_negative, "",
    "Coulomb's coefficient for solids; of two that touch, the geometric mean counts");
  v("solid_restitution", d.solid_restitution, between(0, 1), "",
    "share of the normal speed that a bounce off a solid keeps");
  v("belt_velocity", d.belt_velocity, any_value, "m/s",
    "of a fixed shape's surface along itself, like a belt's; it carries particles, cloth and viscous fluid");
}

template <class V>
void fields(V& v, ShapeDef& d) {
  v("name", d.name, required(not_empty), "", "what probes call this shape");
  v("geometry", d.geometry, required(any_value), "", "what it is");
  v("pose", d.pose, any_value, "", "placement of the geometry");
  flat(v, "surface", d.surface);
  flat(v, "filter", d.filter);
}

}  // namespace meniscus
