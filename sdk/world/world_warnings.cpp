// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a user of a world probably does not intend.
#include <meniscus/world.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "pbd/filter.h"
#include "sdk/world/tuning.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

using world_tuning::deep_overlap;

/// Joins the arguments to one sentence, with numbers of three digits.
template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << parts);
  return text.str();
}

std::string quoted(const char* kind, const std::string& name) {
  return std::string(kind) + " \"" + name + "\"";
}

std::array<float, 3> components(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// Whether a point beyond a face of the container is before an opening in it.
bool is_before_opening(const ContainerGeometry& container, size_t axis, Face face, Vec3 p) {
  const std::array<float, 3> at = components(p);
  return std::ranges::any_of(container.openings, [&](const Opening& opening) {
    if (opening.face != face) return false;
    if (!opening.region) return true;
    const std::array<float, 3> lower = components(opening.region->lower),
                               upper = components(opening.region->upper);
    const auto is_within = [&](size_t k) { return k == axis || (at[k] >= lower[k] && at[k] <= upper[k]); };
    return is_within(0) && is_within(1) && is_within(2);
  });
}

/// p in the container's frame.
bool is_outside(const ContainerGeometry& container, Vec3 p) {
  const std::array<float, 3> at = components(p), half = components(container.half_extents);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto face = static_cast<Face>(2 * axis + (at[axis] > 0 ? 1 : 0));
    if (std::abs(at[axis]) > half[axis] && !is_before_opening(container, axis, face, p)) return true;
  }
  return false;
}

/// m: the distance from a float of this size to the next one.
float step_at(float size) {
  return std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
}

}  // namespace

std::vector<std::string> World::Calls::warnings() const {
  std::vector<std::string> warnings;
  impl_->warn_of_overlaps(warnings);
  impl_->warn_of_places(warnings);
  impl_->warn_of_drag(warnings);
  impl_->warn_of_fields(warnings);
  return warnings;
}

void World::Impl::warn_of_overlaps(std::vector<std::string>& warnings) {
  const std::vector<collision::RigidOverlap> pairs = rigid.deep_overlaps(world_tuning::deep_overlap);
  if (!pairs.empty()) {
    const auto& deepest = *std::ranges::max_element(pairs, {}, &collision::RigidOverlap::depth);
    const std::string other = deepest.b.is_body
                                  ? quoted("body", bodies.get(body_id(deepest.b.number)).def.name)
                                  : quoted("shape", shapes.get(shape_id(deepest.b.number)).def.name);
    warnings.push_back(sentence(pairs.size(), pairs.size() == 1 ? " pair" : " pairs",
                                " of solids overlap, the deepest by ", deepest.depth, " m: the ",
                                quoted("body", bodies.get(body_id(deepest.a.number)).def.name), " and the ",
                                other));
  }
  Engine& all = with_all();
  const float radius = def.contact_radius * def.particle_spacing;
  const auto warn = [&](const std::string& whose, std::span<const Vec3> points,
                        const CollisionFilter& filter) {
    if (points.empty()) return;
    const std::vector<float> distances = all.solid_distances(points, radius, filter);
    const auto inside = std::ranges::count_if(distances, [&](float d) { return d < -deep_overlap * radius; });
    if (inside == 0) return;
    warnings.push_back(sentence(inside, " of ", whose, " are inside of solids, the deepest by ",
                                -std::ranges::min(distances), " m"));
  };
  std::vector<Vec3> at(ids.size());
  std::vector<uint32_t> group(ids.size());
  if (!ids.empty()) {
    engine->read_positions(at);
    engine->read_fluids(group);
  }
  fluids.for_each([&](uint32_t index, const ParticleMaterial& material) {
    std::vector<Vec3> own;
    for (size_t i = 0; i < at.size(); ++i) {
      if (group[i] == index) own.push_back(at[i]);
    }
    warn(sentence("the particles of fluid ", index), own, material.filter);
  });
  fetch_cloth();
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    warn("the vertices of the " + quoted("cloth", entry.def.name), entry.range.state.positions,
         entry.range.filter);
  });
}

/// Warns of what is beside the inside of a container, and of what is too far from the origin.
void World::Impl::warn_of_places(std::vector<std::string>& warnings) {
  fetch_cloth();
  float furthest = 0;
  const auto note = [&](Vec3 p) { furthest = std::max(furthest, max_component(abs(p))); };
  std::vector<Vec3> at(ids.size());
  if (!ids.empty()) engine->read_positions(at);
  for (const Vec3 p : at) note(p);
  const auto beside = [&](const std::string& what, const CollisionFilter& filter,
                          std::span<const Vec3> points) {
    for (const Vec3 p : points) note(p);
    shapes.for_each([&](uint32_t, const ShapeEntry& shape) {
      const auto* container = std::get_if<ContainerGeometry>(&shape.def.geometry);
      if (!container || shape.solid.pieces.empty()) return;
      if (!pbd::meet(filter, shape.solid.pieces.front().shape.surface.filter)) return;
      const auto out = [&](Vec3 p) { return is_outside(*container, to_local(shape.def.pose, p)); };
      if (std::ranges::all_of(points, out))
        warnings.push_back(sentence("the ", what, " is outside of the ", quoted("container", shape.def.name),
                                    ", whose walls fill the space around it"));
    });
  };
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    beside(quoted("cloth", entry.def.name), entry.range.filter, entry.range.state.positions);
  });
  bodies.for_each([&](uint32_t number, const BodyEntry& entry) {
    const Vec3 centre = rigid.centre_of_mass(number);
    if (entry.def.motion == BodyMotion::dynamic && !entry.solid.pieces.empty())
      beside(quoted("body", entry.def.name), entry.solid.pieces.front().shape.surface.filter, {&centre, 1});
    else
      note(centre);
  });
  const float step = step_at(furthest), most = world_tuning::coarsest_position * def.particle_spacing;
  if (step > most)
    warnings.push_back(sentence("something is ", furthest,
                                " m from WorldDef::origin, where positions are rounded to ", step,
                                " m: more than 1 % of the spacing of ", def.particle_spacing,
                                " m. An origin near it is more precise"));
}

/// Warns of free fall that is not free.
void World::Impl::warn_of_drag(std::vector<std::string>& warnings) {
  if (length(def.gravity) == 0) return;
  bodies.for_each([&](uint32_t, const BodyEntry& entry) {
    if (entry.def.motion == BodyMotion::dynamic && entry.def.linear_damping > 0)
      warnings.push_back(sentence("the ", quoted("body", entry.def.name), " does not fall freely: it loses ",
                                  100 * entry.def.linear_damping,
                                  " % of its speed a second (linear_damping)"));
  });
  if (air_density == 0) return;
  cloths.for_each([&](uint32_t index, const ClothEntry& entry) {
    const bool is_held = std::ranges::any_of(held_vertices(cloths.id(index)), [](bool h) { return h; });
    const FabricDef& fabric = entry.def.fabric;
    if (is_held || fabric.drag == 0) return;
    // m g = ½ ρ C_D A v², flat against the air
    const float speed = std::sqrt(2 * fabric.density * length(def.gravity) / (air_density * fabric.drag));
    warnings.push_back(sentence("the ", quoted("cloth", entry.def.name), " does not fall freely: air of ",
                                air_density, " kg/m³ bounds its fall to about ", speed,
                                " m/s. WindDef::air_density = 0 is no air"));
  });
}

/// Warns of distance fields that take long to compute.
void World::Impl::warn_of_fields(std::vector<std::string>& warnings) {
  const auto warn = [&](const std::string& what, const SolidPieces& solid) {
    for (const SolidPieces::Piece& piece : solid.pieces) {
      if (piece.shape.kind != collision::ShapeKind::sdf) continue;
      const size_t nodes = engine->sdf_nodes(piece.shape.table);
      if (nodes > world_tuning::many_field_nodes)
        warnings.push_back(sentence("the field of the ", what, " has ", static_cast<double>(nodes),
                                    " nodes and takes long to compute. A larger MeshGeometry::cell_size or "
                                    "particle_spacing is faster"));
    }
  };
  shapes.for_each([&](uint32_t, const ShapeEntry& s) { warn(quoted("shape", s.def.name), s.solid); });
  bodies.for_each([&](uint32_t, const BodyEntry& b) { warn(quoted("body", b.def.name), b.solid); });
}

}  // namespace meniscus
