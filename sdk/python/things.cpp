// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The classes Fluid, Shape, Emitter, Sink, Probe, Joint and ForceField.
#include "sdk/python/things.h"

#include "sdk/python/definitions.h"
#include "sdk/python/thing.h"

namespace meniscus::python {

namespace {

/// A call that sets vectors of all particles of a fluid.
void bind_set(nb::class_<Handle<FluidId>>& fluid, const char* call, const char* argument,
              void (World::*set)(FluidId, std::span<const Vec3>), const char* doc) {
  const std::string text =
      "def " + std::string(call) + "(self, " + argument + ": numpy.typing.ArrayLike) -> None";
  fluid.def(
      call,
      [=](const Handle<FluidId>& self, nb::handle given) {
        std::vector<Vec3> values;
        read(given, {call, argument}, values);
        self.state->change([&](World& w) { (w.*set)(self.id, values); });
      },
      nb::arg(argument), nb::sig(text.c_str()), doc);
}

void bind_fluid(nb::module_& module, nb::class_<PyWorld>& world) {
  nb::class_<Handle<FluidId>> fluid = bind_thing(module, world, "fluid", "fluids", &Things::fluids);
  bind_creation<FluidDef>(world, "add_fluid", &Things::fluids, &World::create_fluid,
                          "Adds a kind of liquid. add_volume and emitters make its particles.");
  bind_creation<GranularDef>(world, "add_granular", &Things::fluids, &World::create_granular,
                             "Adds a granular material, such as sand.");
  fluid.def_prop_ro(
      "index", [](const Handle<FluidId>& self) { return self.id.index; },
      "Its number in World.fluid_indices.");
  bind_answer(
      fluid, "particle_mass", "float", [](World& w, FluidId id) { return w.particle_mass(id); }, "kg.");
  bind_fluid_members(fluid);
  bind_filter(fluid);
  bind_set(fluid, "set_positions", "positions", &World::set_positions,
           "m, of all its particles, in the order of ids. Velocities stay.");
  bind_set(fluid, "set_velocities", "velocities", &World::set_velocities,
           "m/s, of all its particles, in the order of ids.");
  const Description text = describe_call<FluidVolumeDef>(
      "add_volume", "int", "Fills a region with particles. Returns how many there are.");
  world.def(
      "add_volume",
      [](const PyWorld& self, const nb::kwargs& given) {
        FluidVolumeDef def;
        read_members(def, given, "add_volume");
        return self.state->change([&](World& w) { return w.add_fluid(def); });
      },
      nb::sig(text.signature.c_str()), text.doc.c_str());
}

template <class Id>
void bind_count(nb::class_<Handle<Id>>& type, FlowCount (World::*count)(Id) const) {
  bind_answer(
      type, "total", "int", [count](World& w, Id id) { return (w.*count)(id).total; },
      "Particles since its creation.");
  bind_answer(
      type, "last_step", "int", [count](World& w, Id id) { return (w.*count)(id).last_step; },
      "Particles in the last step.");
}

void bind_probe(nb::module_& module, nb::class_<PyWorld>& world) {
  nb::class_<Handle<ProbeId>> probe = bind_thing(module, world, "probe", "probes", &Things::probes);
  bind_creation<ProbeDef>(world, "add_probe", &Things::probes, &World::create_probe,
                          "Adds a measurement, the mean over the substeps of a step.");
  bind_destruction(probe, &Things::probes, &World::destroy_probe, "Removes it.");
  bind_answer(
      probe, "value", "float", [](World& w, ProbeId id) { return w.probe(id); },
      "Of the last step, in the unit of its kind. Of a vector, its length.");
  bind_answer(
      probe, "vector", "tuple[float, float, float]", [](World& w, ProbeId id) { return w.probe_vector(id); },
      "Of the last step, of a kind with vectors; 0 of the others.");
}

}  // namespace

void bind_things(nb::module_& module, nb::class_<PyWorld>& world) {
  bind_fluid(module, world);
  nb::class_<Handle<ShapeId>> shape = bind_thing(module, world, "shape", "shapes", &Things::shapes);
  bind_creation<ShapeDef>(world, "add_shape", &Things::shapes, &World::create_shape,
                          "Adds a solid that does not move.");
  bind_destruction(shape, &Things::shapes, &World::destroy_shape, "Removes it.");
  bind_surfaces(shape);
  nb::class_<Handle<JointId>> joint = bind_thing(module, world, "joint", "joints", &Things::joints);
  bind_creation<JointDef>(world, "add_joint", &Things::joints, &World::create_joint,
                          "Joins two bodies, or a body and the world.");
  bind_destruction(joint, &Things::joints, &World::destroy_joint, "Removes it.");
  bind_answer(
      joint, "angle", "float", [](World& w, JointId id) { return w.hinge_angle(id); },
      "rad, of a hinge, from the pose at its creation.");
  nb::class_<Handle<EmitterId>> emitter = bind_thing(module, world, "emitter", "emitters", &Things::emitters);
  bind_creation<EmitterDef>(world, "add_emitter", &Things::emitters, &World::create_emitter,
                            "Adds an opening that makes particles.");
  bind_destruction(emitter, &Things::emitters, &World::destroy_emitter, "Removes it.");
  bind_count(emitter, &World::emitter_count);
  bind_answer(
      emitter, "pressure", "float", [](World& w, EmitterId id) { return w.emitter_pressure(id); },
      "Pa, on the piston of an imposed emitter, mean over its opening and the last step.");
  nb::class_<Handle<SinkId>> sink = bind_thing(module, world, "sink", "sinks", &Things::sinks);
  bind_creation<SinkDef>(world, "add_sink", &Things::sinks, &World::create_sink,
                         "Adds a region that removes particles.");
  bind_destruction(sink, &Things::sinks, &World::destroy_sink, "Removes it.");
  bind_count(sink, &World::sink_count);
  bind_probe(module, world);
  nb::class_<Handle<ForceFieldId>> field =
      bind_thing(module, world, "force_field", "force_fields", &Things::force_fields);
  bind_creation<ForceFieldDef>(world, "add_force_field", &Things::force_fields, &World::create_force_field,
                               "Adds a force beside gravity. Its members can change later.");
  bind_destruction(field, &Things::force_fields, &World::destroy_force_field, "Removes it.");
  bind_force_field_members(field);
}

}  // namespace meniscus::python
