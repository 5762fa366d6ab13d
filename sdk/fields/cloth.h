// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth and its fabric.
#pragma once

#include <meniscus/cloth.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/fields/keyframes.h"
#include "sdk/fields/names.h"
#include "sdk/fields/shapes.h"

namespace meniscus {

constexpr auto names_of(StretchModel) {
  return std::array{Named{"edges", StretchModel::edges}, Named{"triangles", StretchModel::triangles}};
}
constexpr auto names_of(BendingModel) {
  return std::array{Named{"isometric", BendingModel::isometric}, Named{"dihedral", BendingModel::dihedral}};
}

/// A stiffness of fabric, by name.
enum class FabricStiffness { warp, weft, shear, bending };

constexpr auto names_of(FabricStiffness) {
  return std::array{Named{"warp", FabricStiffness::warp}, Named{"weft", FabricStiffness::weft},
                    Named{"shear", FabricStiffness::shear}, Named{"bending", FabricStiffness::bending}};
}

/// JSON has no infinity: what does not give way is named, as the held axes of a spring are.
inline void make_unyielding(const std::vector<FabricStiffness>& names, FabricDef& d) {
  float FabricDef::*const members[] = {&FabricDef::warp_stiffness, &FabricDef::weft_stiffness,
                                       &FabricDef::shear_stiffness, &FabricDef::bending_stiffness};
  for (const FabricStiffness name : names)
    d.*members[static_cast<int>(name)] = std::numeric_limits<float>::infinity();
}

template <class V>
void fields(V& v, FabricDef& d) {
  std::vector<FabricStiffness> unyielding;
  v("density", d.density, between(1e-6, 1e4), "kg/m²", "mass of an area");
  v("stretch_model", d.stretch_model, any_value, "",
    "what stretch and shear act on: the lengths of edges, or the strain of triangles");
  v("warp_stiffness", d.warp_stiffness, or_infinity(not_negative), "N/m",
    "tension over strain, along the warp");
  v("weft_stiffness", d.weft_stiffness, or_infinity(not_negative), "N/m",
    "tension over strain, along the weft");
  v("shear_stiffness", d.shear_stiffness, or_infinity(not_negative), "N/m",
    "shear force over the shear angle");
  v("bending_model", d.bending_model, any_value, "",
    "how bending is measured; isometric is for cloth that is flat at rest, and dihedral where it is not");
  v("bending_stiffness", d.bending_stiffness, or_infinity(not_negative), "N·m", "moment over curvature");
  v("unyielding", unyielding, key_only(any_value), "", "what does not give way, whatever its stiffness");
  v("stretch_damping", d.stretch_damping, between(0, 1e6), "s",
    "Rayleigh's, of stretch and shear: viscous forces are so many times the elastic ones' rate");
  v("bending_damping", d.bending_damping, between(0, 1e6), "s", "likewise of bending");
  v("thickness", d.thickness, between(0, 1e3), "m",
    "distance that two layers keep; 0 is a quarter of the mean edge");
  v("friction", d.friction, not_negative, "",
    "Coulomb's coefficient between cloth and cloth; on a solid, the solid's counts");
  v("fluid_friction", d.fluid_friction, not_negative, "", "Coulomb's coefficient between fluid and cloth");
  v("fluid_adhesion", d.fluid_adhesion, not_negative, "Pa", "pull on a wet layer of particles, per area");
  v("slip_length", d.slip_length, or_infinity(not_negative), "m", slip_length_text);
  v("permittivity", d.permittivity, not_negative, "1/s",
    "flow of fluid through the cloth, in m/s for each metre of water column across it; 0 is tight");
  v("absorbency", d.absorbency, not_negative, "kg/m²", "fluid that it takes up at most; 0 is none");
  v("retention", d.retention, between(0, 1), "",
    "share of that which it keeps; the rest runs down and drips");
  v("drainage", d.drainage, not_negative, "m/s", "how fast that runs down steep cloth");
  v("drag", d.drag, not_negative, "", "drag coefficient of a flat plate; 0 is none");
  v("lift", d.lift, not_negative, "", "lift coefficient of a flat plate");
  v("tear_strain", d.tear_strain, not_negative, "", "edges stretched further than this tear; 0 is never");
  make_unyielding(unyielding, d);
}

template <class V>
void fields(V& v, SheetGeometry& d) {
  v("width", d.width, positive, "m", "along x, the warp");
  v("depth", d.depth, positive, "m", "along z, the weft");
  v("columns", d.columns, between(2, 10000), "", "vertices along x");
  v("rows", d.rows, between(2, 10000), "",
    "vertices along z; vertex (column, row) has the number row · columns + column");
}

template <class V>
void fields(V& v, ClothFile& d) {
  v("file", d.file, required(any_value), "", mesh_file_text);
  v("scale", d.scale, positive, "m", "length of a unit of the file");
  v("weld", d.weld, between(0, 0.1), "", "in mean edges: vertices no further apart are merged");
}

/// Numbers of vertices, three for each triangle.
template <class V>
void triangle_field(V& v, std::vector<uint32_t>& triangles) {
  FieldRule three = between(0, std::numeric_limits<uint32_t>::max());
  three.min_items = 3;
  v("triangles", triangles, required(three), "", "three numbers of vertices each, counted from 0");
  v.check(triangles.size() % 3 == 0,
          "triangles must hold three numbers each, but there are " + std::to_string(triangles.size()),
          "triangles", triangles);
}

template <class V>
void fields(V& v, ClothTriangles& d) {
  v("vertices", d.vertices, required(with_items(3)), "m", "where they are at rest");
  triangle_field(v, d.triangles);
}

template <class V>
void fields(V& v, ClothKeyframe& d) {
  v("time", d.time, required(not_negative), "s", "when, from the start of the run");
  v("vertices", d.vertices, required(with_items(3)), "m", "where they are then");
}

template <class V>
void fields(V& v, DrivenTriangles& d) {
  for (std::size_t k = 0; k < d.keyframes.size(); ++k) {  // names the keyframe, which a vertex does not
    const std::vector<Vec3>& x = d.keyframes[k].vertices;
    const auto bad = std::ranges::find_if_not(x, [](Vec3 p) { return is_finite(p); });
    v.check(bad == x.end(), "ClothKeyframe::vertices[" + std::to_string(bad - x.begin()) + "] of keyframe " +
                                std::to_string(k) + " is not finite");
  }
  triangle_field(v, d.triangles);
  v("keyframes", d.keyframes, required(not_empty), "", "places of the vertices, in the order of the times");
  v("loop", d.loop, any_value, "", "after the last keyframe the first follows; else the surface stays there");
  check_keyframes(v, d.keyframes, d.loop);
  for (std::size_t k = 1; k < d.keyframes.size(); ++k) {
    const std::size_t here = d.keyframes[k].vertices.size(), first = d.keyframes[0].vertices.size();
    v.check(here == first,
            "keyframe " + std::to_string(k) + " has " + std::to_string(here) + " vertices, and keyframe 0 " +
                std::to_string(first) + ": a driven surface keeps its triangles",
            "keyframes", d.keyframes);
  }
}

template <class V>
void fields(V& v, DrivenFiles& d) {
  constexpr FieldRule number = between(0, 999999999);
  v("files", d.files, required(any_value), "",
    "path of mesh files from the scene's folder, with %d or %04d for the number of a frame");
  v("first", d.first, number, "", "number of the first file");
  v("last", d.last, number, "", "number of the last file");
  v("frames_per_second", d.frames_per_second, between(1e-3, 1e6), "1/s", "files a second");
  v("start", d.start, not_negative, "s", "when the first file counts, from the start of the run");
  v("scale", d.scale, positive, "m", "length of a unit of the files");
  v("loop", d.loop, any_value, "", "after the last file the first follows; else the surface stays there");
  v.check(d.first <= d.last, "first must not be above last", "first", d.first);
  v.check(!d.loop || d.first < d.last, "loop needs at least 2 files", "last", d.last);
}

template <class V>
void fields(V& v, ClothSphere& d) {
  v("radius", d.radius, positive, "m", "radius");
  v("divisions", d.divisions, between(1, 500), "",
    "of an edge of the icosahedron that it is made from; there are 10 · divisions² + 2 vertices");
}

template <class V>
void fields(V& v, ClothTube& d) {
  v("top_radius", d.top_radius, positive, "m", "radius at the upper end");
  v("bottom_radius", d.bottom_radius, positive, "m", "radius at the lower end");
  v("height", d.height, positive, "m", "from end to end");
  v("columns", d.columns, between(3, 10000), "", "vertices around");
  v("rows", d.rows, between(2, 10000), "",
    "vertices from top to bottom; vertex (column, row) has the number row · columns + column");
  v("bottom", d.bottom, any_value, "", "whether a disc closes the lower end; its vertices come last");
}

template <class V>
void choices(V& v, ClothGeometry& g) {
  v.choice("sheet", SheetGeometry{}, g, "a flat sheet in the plane y = 0, centred");
  v.choice("mesh", ClothFile{}, g, "the triangles of a file");
  v.choice("triangles", ClothTriangles{}, g, "any triangles");
  v.choice("sphere", ClothSphere{}, g, "a closed sphere");
  v.choice("tube", ClothTube{}, g, "a tube or cone about y, open at both ends or a bag");
  v.choice("driven_triangles", DrivenTriangles{}, g,
           "a driven surface: its vertices move as given, whatever they meet");
  v.choice("driven_files", DrivenFiles{}, g, "a driven surface from numbered mesh files");
}

template <class V>
void fields(V& v, InflationDef& d) {
  v("pressure", d.pressure, any_value, "Pa",
    "above the air outside, at the volume that the cloth has at rest");
  v("air_pressure", d.air_pressure, positive, "Pa",
    "outside: how much the gas resists a change of its volume");
  v.check(d.pressure > -d.air_pressure, "pressure must be greater than minus the air_pressure", "pressure",
          d.pressure);
}

template <class V>
void fields(V& v, ClothDef& d) {
  v("name", d.name, required(not_empty), "", "what attachments and outputs call this piece");
  v("geometry", d.geometry, required(any_value), "", "its shape at rest");
  v("pose", d.pose, any_value, "", "placement of the geometry at the start");
  v("stretch", d.stretch, positive, "", "at the start the geometry is scaled by this; at rest it is not");
  v("velocity", d.velocity, any_value, "m/s", "at the start");
  v("fabric", d.fabric, any_value, "", "what it is made of");
  flat(v, "filter", d.filter);
  v("self_collision", d.self_collision, any_value, "", "whether it collides with itself");
  v("tethers", d.tethers, any_value, "",
    "whether strips of the fabric pull vertices to the nearest one that is held fast");
  v("inflation", d.inflation, any_value, "", "gas inside a closed piece; left out, there is none");
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
}

}  // namespace meniscus
