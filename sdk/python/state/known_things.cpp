// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the definitions of what exists in a world.
#include "sdk/python/state/known_things.h"

#include <algorithm>
#include <filesystem>

#include "sdk/files/output_file.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/state/definitions.h"

namespace meniscus::python {

namespace {

template <class Id, class Def>
void take(Registry<Id, Def>& registry, const std::vector<Id>& ids,
          const std::vector<std::optional<Def>>& defs) {
  for (const Id id : ids) registry.add(id, defs.at(id.index).value());
}

/// A file of 0.2 has neither colours nor the friction that was given.
std::variant<FluidDef, GranularDef> def_of(const ParticleMaterial& m) {
  if (m.grain.is_grain) {
    GranularDef def;
    def.name = m.name;
    def.density = m.fluid.rest_density;
    def.friction = m.slope.value_or(def.friction);
    def.filter = m.filter;
    def.color = m.color.value_or(def.color);
    return def;
  }
  FluidDef def;
  def.name = m.name;
  def.rest_density = m.fluid.rest_density;
  def.dynamic_viscosity = m.fluid.dynamic_viscosity;
  def.xsph = m.fluid.xsph;
  def.vorticity_confinement = m.fluid.vorticity_confinement;
  def.cohesion = m.fluid.cohesion;
  def.surface_tension = m.fluid.surface_tension;
  def.filter = m.filter;
  def.color = m.color.value_or(def.color);
  return def;
}

template <class Id, class Def>
void renumber(Registry<Id, Def>& registry, const std::vector<Id>& ids) {
  for (Id& id : registry.ids) {
    const auto same = std::find_if(ids.begin(), ids.end(), [&](Id other) { return other.index == id.index; });
    if (same != ids.end()) id = *same;
  }
}

/// A file that goes when this does.
struct PassingFile {
  std::filesystem::path path = io::make_part(std::filesystem::temp_directory_path() / "meniscus");

  PassingFile() = default;
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;
  ~PassingFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

}  // namespace

Things things_of(const World& w, const std::string& definitions) {
  const Definitions defs = read_definitions(definitions, 0);  // ids within them count from 0
  Things all;
  for (const FluidId id : w.fluid_ids()) all.fluids.add(id, def_of(defs.fluids.at(id.index).value()));
  take(all.shapes, w.shape_ids(), defs.shapes);
  take(all.bodies, w.body_ids(), defs.bodies);
  take(all.joints, w.joint_ids(), defs.joints);
  take(all.cloths, w.cloth_ids(), defs.cloths);
  take(all.ropes, w.rope_ids(), defs.ropes);
  take(all.attachments, w.attachment_ids(), defs.attachments);
  take(all.emitters, w.emitter_ids(), defs.emitters);
  take(all.sinks, w.sink_ids(), defs.sinks);
  take(all.probes, w.probe_ids(), defs.probes);
  take(all.force_fields, w.force_field_ids(), defs.force_fields);
  return all;
}

Things things_of(const World& w, Things all) {
  renumber(all.fluids, w.fluid_ids());
  renumber(all.shapes, w.shape_ids());
  renumber(all.bodies, w.body_ids());
  renumber(all.joints, w.joint_ids());
  renumber(all.cloths, w.cloth_ids());
  renumber(all.ropes, w.rope_ids());
  renumber(all.attachments, w.attachment_ids());
  renumber(all.emitters, w.emitter_ids());
  renumber(all.sinks, w.sink_ids());
  renumber(all.probes, w.probe_ids());
  renumber(all.force_fields, w.force_field_ids());
  return all;
}

Things saved_things(const World& w) {
  const PassingFile file;
  w.save(file.path.string());
  return things_of(w, read_chunk_file_header(file.path.string()).definitions);
}

}  // namespace meniscus::python
