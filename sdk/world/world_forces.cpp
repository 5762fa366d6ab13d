// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's force fields.
#include <algorithm>
#include <cmath>

#include "sdk/world/check/check.h"
#include "sdk/world/world_boundary.h"
#include "sdk/world/world_recorded.h"

namespace meniscus {

namespace {

using Kind = ForceField::Kind;

/// Fills in the law of a field, one overload a kind. Vectors turn with the frame.
struct FillForce {
  ForceFieldModel& model;
  Quat turn;

  void operator()(const UniformForce& f) const {
    model.field.kind = Kind::uniform;
    model.field.vector = rotate(turn, f.value);
  }
  void operator()(const RadialForce& f) const {
    model.field.kind = Kind::radial;
    model.field.strength = f.strength;
    model.field.size = f.radius;
    model.field.exponent = f.exponent;
    model.field.softening2 = f.softening * f.softening;
  }
  void operator()(const VortexForce& f) const {
    model.field.kind = Kind::vortex;
    model.field.vector = rotate(turn, {0, f.angular_velocity, 0});
    model.field.rate = f.rate;
  }
  void operator()(const DragForce& f) const {
    model.field.kind = Kind::drag;
    model.field.vector = rotate(turn, f.velocity);
    model.field.rate = f.linear;
    model.field.strength = f.quadratic;
  }
  void operator()(const NoiseForce& f) const {
    model.field.kind = Kind::noise;
    model.field.strength = f.strength;
    model.field.size = f.size;
    model.field.period = f.period;
    model.field.seed = f.seed;
  }
  void operator()(const GridForce& f) const {
    model.field.kind = Kind::grid;
    model.field.lower = f.lower;
    model.field.size = f.cell_size;
    model.field.nodes_x = static_cast<uint32_t>(f.nodes_x);
    model.field.nodes_y = static_cast<uint32_t>(f.nodes_y);
    model.field.nodes_z = static_cast<uint32_t>(f.nodes_z);
    model.values = f.values;
    for (const Vec3 value : f.values) model.field.strength = std::max(model.field.strength, length(value));
  }
};

struct FillForceRegion {
  ForceField& field;

  void operator()(const EverywhereRegion&) const { field.region = ForceField::Region::everywhere; }
  void operator()(const BoxRegion& r) const {
    field.region = ForceField::Region::box;
    field.box = {r.lower, r.upper};
  }
  void operator()(const BallRegion& r) const {
    field.region = ForceField::Region::ball;
    field.ball_radius = r.radius;
  }
};

ForceFieldModel model_of(const ForceFieldDef& def) {
  ForceFieldModel model;
  ForceField& field = model.field;
  field.pose = def.pose;
  field.targets = (def.fluids ? ForceField::fluids : 0u) | (def.grains ? ForceField::grains : 0u) |
                  (def.cloth ? ForceField::cloth : 0u) | (def.bodies ? ForceField::bodies : 0u);
  field.is_per_volume = def.quantity == ForceQuantity::force_density;
  std::visit(FillForceRegion{field}, def.region);
  std::visit(FillForce{model, def.pose.rotation}, def.force);
  return model;
}

}  // namespace

ForceFieldId World::Calls::create_force_field(const ForceFieldDef& def) {
  check::def(def);
  impl_->forces_changed();
  return impl_->force_fields.insert(def);
}

void World::Calls::set_force_field(ForceFieldId id, const ForceFieldDef& def) {
  ForceFieldDef& known = impl_->force_fields.edit(id);
  check::def(def);
  ForceFieldDef copy = def;
  impl_->forces_changed();
  known = std::move(copy);
}

void World::Calls::destroy_force_field(ForceFieldId id) {
  impl_->force_fields.erase(id);
  impl_->forces_changed();
}

std::vector<ForceFieldId> World::Calls::force_field_ids() const {
  return impl_->force_fields.ids();
}

namespace {

/// What fields act on where they act on volumes: that of a rope's radius, and of a cloth's given thickness.
class VolumesOf {
 public:
  explicit VolumesOf(size_t vertices) { all.volumes.resize(vertices); }

  void add(const ClothEntry& cloth) {
    const FabricDef& f = cloth.def.fabric;
    if (f.thickness > 0) add(cloth.range, cloth.constraints.masses, f.density / f.thickness);
  }
  void add(const RopeEntry& rope) { add(rope.range, rope.range.masses, rope.def.density); }

  VertexVolumes all;

 private:
  void add(const VertexRange& range, std::span<const float> dry_masses, float density) {
    for (uint32_t v = 0; v < range.count(); ++v) all.volumes[range.first + v] = dry_masses[v] / density;
    all.least_density = std::min(all.least_density, density);
  }
};

}  // namespace

/// Fields need the densities of bodies and the numbers of vertices, so they are uploaded anew when solids or
/// cloth have changed.
void World::Impl::upload_forces() {
  if (forces_are_on_device) return;
  std::vector<ForceFieldModel> models;
  force_fields.for_each([&](uint32_t, const ForceFieldDef& f) { models.push_back(model_of(f)); });
  std::vector<float> densities;
  bodies.for_each([&](uint32_t number, const BodyEntry& entry) {
    densities.resize(number + 1, 1.0f);
    if (entry.mass.volume > 0) densities[number] = entry.mass.mass / entry.mass.volume;
  });
  const bool on_volumes = std::ranges::any_of(models, [](const ForceFieldModel& m) {
    return m.field.is_per_volume && m.field.targets & ForceField::cloth;
  });
  VolumesOf vertices(on_volumes ? vertex_count : 0);
  if (on_volumes) {
    cloths.for_each([&](uint32_t, const ClothEntry& cloth) { vertices.add(cloth); });
    ropes.for_each([&](uint32_t, const RopeEntry& rope) { vertices.add(rope); });
  }
  engine->set_force_fields(models, densities, vertices.all);
  forces_are_on_device = true;
}

ForceFieldId World::create_force_field(const ForceFieldDef& def) {
  return impl_->recorded(
      "create_force_field", [&](auto w) { return w.create_force_field(w.inward(def)); }, def);
}
void World::set_force_field(ForceFieldId id, const ForceFieldDef& def) {
  return impl_->recorded(
      "set_force_field", [&](auto w) { return w.set_force_field(id, w.inward(def)); }, id, def);
}
void World::destroy_force_field(ForceFieldId id) {
  return impl_->recorded(
      "destroy_force_field", [&](auto w) { return w.destroy_force_field(id); }, id);
}
std::vector<ForceFieldId> World::force_field_ids() const {
  return impl_->run([&](auto w) { return w.force_field_ids(); });
}

}  // namespace meniscus
