// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that set poses, filters and surfaces of what is there.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/solids/seam_images.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

void set_filters(SolidPieces& solid, const CollisionFilter& filter) {
  for (SolidPieces::Piece& piece : solid.pieces) piece.shape.surface.filter = filter;
}

/// The definition with another surface, checked.
template <class Def>
Def with_surface(Def def, const SurfaceDef& surface) {
  def.surface = surface;
  check::def(def);
  return def;
}

}  // namespace

void World::Calls::set_shape_pose(ShapeId id, const Pose& pose) {
  ShapeEntry& entry = impl_->shapes.edit(id);
  check::value("set_shape_pose's pose", pose);
  const pbd::PeriodicAxes axes = periodic_axes(impl_->def.periodic);
  for (const SolidPieces::Piece& piece : entry.solid.pieces)
    with_seam_images(placed(piece, pose), axes, impl_->kernel.h, entry.def.name);
  impl_->monitor().commit();
  impl_->rigid.set_fixed_pose(id.index, pose);
  entry.def.pose = pose;
  impl_->solids_changed();
}

void World::Calls::set_filter(ShapeId id, const CollisionFilter& filter) {
  ShapeEntry& entry = impl_->shapes.edit(id);
  impl_->monitor().commit();
  impl_->rigid.set_filter({false, id.index}, filter);
  entry.def.filter = filter;
  set_filters(entry.solid, filter);
  impl_->solids_changed();
}

void World::Calls::set_filter(BodyId id, const CollisionFilter& filter) {
  BodyEntry& entry = impl_->bodies.edit(id);
  impl_->monitor().commit();
  impl_->rigid.set_filter({true, id.index}, filter);
  entry.def.filter = filter;
  set_filters(entry.solid, filter);
  impl_->solids_changed();
}

void World::Calls::set_filter(ClothId id, const CollisionFilter& filter) {
  ClothEntry& entry = impl_->cloths.edit(id);
  impl_->cloth_changed();
  entry.def.filter = entry.range.filter = filter;
  entry.range.placed = true;  // it may overlap what it now collides with
}

void World::Calls::set_filter(RopeId id, const CollisionFilter& filter) {
  RopeEntry& entry = impl_->ropes.edit(id);
  impl_->cloth_changed();
  entry.def.filter = entry.range.filter = filter;
  entry.range.placed = true;
}

/// With the solids, what may overlap them is looked for again.
void World::Calls::set_filter(FluidId id, const CollisionFilter& filter) {
  ParticleMaterial& material = impl_->fluids.edit(id);
  impl_->cloth_changed();  // the fluids that load it may differ now
  impl_->solids_are_on_device = impl_->materials_are_on_device = false;
  material.filter = filter;
}

void World::Calls::set_surface(ShapeId id, const SurfaceDef& surface) {
  ShapeEntry& entry = impl_->shapes.edit(id);
  ShapeDef changed = with_surface(entry.def, surface);
  impl_->monitor().commit();
  impl_->rigid.set_surface({false, id.index}, surface.solid_friction, surface.solid_restitution);
  entry.def = std::move(changed);
  set_surfaces(entry.solid, surface, impl_->def.particle_spacing);
  impl_->solids_changed();
}

void World::Calls::set_surface(BodyId id, const SurfaceDef& surface) {
  BodyEntry& entry = impl_->bodies.edit(id);
  BodyDef changed = with_surface(entry.def, surface);
  impl_->monitor().commit();
  impl_->rigid.set_surface({true, id.index}, surface.solid_friction, surface.solid_restitution);
  entry.def = std::move(changed);
  set_surfaces(entry.solid, surface, impl_->def.particle_spacing);
  impl_->solids_changed();
}

}  // namespace meniscus
