// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of definitions of cloth, ropes, attachments and wind.
#include <meniscus/cloth.h>
#include <meniscus/error.h>

#include <cmath>
#include <limits>

#include "sdk/world/check/check.h"

namespace meniscus::check {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// ≥ 0, or infinite.
void stiffness(const char* name, float value) {
  if (!(value >= 0)) refuse(name, std::to_string(value), "≥ 0, or infinity");
}

void fabric(const FabricDef& f) {
  between("FabricDef::density", f.density, 1e-6f, 1e4f);
  one_of("FabricDef::stretch_model", f.stretch_model, StretchModel::triangles);
  one_of("FabricDef::bending_model", f.bending_model, BendingModel::dihedral);
  stiffness("FabricDef::warp_stiffness", f.warp_stiffness);
  stiffness("FabricDef::weft_stiffness", f.weft_stiffness);
  stiffness("FabricDef::shear_stiffness", f.shear_stiffness);
  stiffness("FabricDef::bending_stiffness", f.bending_stiffness);
  between("FabricDef::stretch_damping", f.stretch_damping, 0.0f, 1e6f);
  between("FabricDef::bending_damping", f.bending_damping, 0.0f, 1e6f);
  between("FabricDef::thickness", f.thickness, 0.0f, 1e3f);
  not_negative("FabricDef::friction", f.friction);
  not_negative("FabricDef::fluid_friction", f.fluid_friction);
  not_negative("FabricDef::fluid_adhesion", f.fluid_adhesion);
  not_negative("FabricDef::permittivity", f.permittivity);
  not_negative("FabricDef::absorbency", f.absorbency);
  between("FabricDef::retention", f.retention, 0.0f, 1.0f);
  not_negative("FabricDef::drainage", f.drainage);
  not_negative("FabricDef::drag", f.drag);
  not_negative("FabricDef::lift", f.lift);
  not_negative("FabricDef::tear_strain", f.tear_strain);
}

struct CheckGeometry {
  void operator()(const SheetGeometry& g) const {
    positive("SheetGeometry::width", g.width);
    positive("SheetGeometry::depth", g.depth);
    between("SheetGeometry::columns", g.columns, 2, 10000);
    between("SheetGeometry::rows", g.rows, 2, 10000);
  }
  void operator()(const ClothFile& g) const { positive("ClothFile::scale", g.scale); }
  void operator()(const ClothTriangles& g) const {
    if (g.triangles.empty() || g.triangles.size() % 3 != 0)
      refuse("ClothTriangles::triangles", std::to_string(g.triangles.size()) + " numbers",
             "three a triangle, at least one triangle");
  }
  void operator()(const ClothSphere& g) const {
    positive("ClothSphere::radius", g.radius);
    between("ClothSphere::divisions", g.divisions, 1, 500);
  }
  void operator()(const ClothTube& g) const {
    positive("ClothTube::top_radius", g.top_radius);
    positive("ClothTube::bottom_radius", g.bottom_radius);
    positive("ClothTube::height", g.height);
    between("ClothTube::columns", g.columns, 3, 10000);
    between("ClothTube::rows", g.rows, 2, 10000);
  }
};

}  // namespace

void cloth(const ClothDef& def) {
  std::visit(CheckGeometry{}, def.geometry);
  pose("ClothDef::pose", def.pose);
  positive("ClothDef::stretch.x", def.stretch.x);
  positive("ClothDef::stretch.y", def.stretch.y);
  positive("ClothDef::stretch.z", def.stretch.z);
  finite("ClothDef::velocity", def.velocity);
  color("ClothDef::color", def.color);
  fabric(def.fabric);
  if (!def.inflation) return;
  positive("InflationDef::air_pressure", def.inflation->air_pressure);
  finite("InflationDef::pressure", def.inflation->pressure);
  if (def.inflation->pressure <= -def.inflation->air_pressure)
    refuse("InflationDef::pressure", std::to_string(def.inflation->pressure), "above minus the air pressure");
}

void rope(const RopeDef& def) {
  if (def.points.size() < (def.closed ? 3u : 2u)) {
    refuse("RopeDef::points", std::to_string(def.points.size()) + " points",
           def.closed ? "at least 3, as the rope is closed" : "at least 2");
  }
  for (Vec3 p : def.points) finite("a point of RopeDef::points", p);
  between("RopeDef::segments", def.segments, 0, 1000000);
  pose("RopeDef::pose", def.pose);
  finite("RopeDef::velocity", def.velocity);
  between("RopeDef::radius", def.radius, 1e-6f, 1e3f);
  density("RopeDef::density", def.density);
  between("RopeDef::youngs_modulus", def.youngs_modulus, 1e-6f, infinity);
  between("RopeDef::shear_modulus", def.shear_modulus, 1e-6f, infinity);
  not_negative("RopeDef::damping", def.damping);
  color("RopeDef::color", def.color);
}

void attachment(const AttachmentDef& def) {
  if (def.cloth.has_value() == def.rope.has_value())
    throw Error(ErrorCode::invalid_argument, "AttachmentDef needs a cloth or a rope, and not both");
  if (def.body.has_value() + def.other_cloth.has_value() + def.other_rope.has_value() > 1)
    throw Error(ErrorCode::invalid_argument,
                "AttachmentDef has more than one of body, other_cloth and other_rope");
  if (def.region) box("AttachmentDef::region", *def.region);
  if (def.vertices.empty() && !def.region)
    throw Error(ErrorCode::invalid_argument, "AttachmentDef needs vertices or a region");
  positive("AttachmentDef::reach", def.reach);
  not_negative("AttachmentDef::compliance", def.compliance);
}

void wind(const WindDef& def) {
  finite("WindDef::velocity", def.velocity);
  not_negative("WindDef::air_density", def.air_density);
  between("WindDef::gust_speed", def.gust_speed, 0.0f, 1e6f);
  positive("WindDef::gust_size", def.gust_size);
}

}  // namespace meniscus::check
