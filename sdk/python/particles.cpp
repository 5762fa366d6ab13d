// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays of particles, and the calls that add, push and remove particles.
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/describe.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/values/results.h"

namespace meniscus::python {

namespace {

constexpr const char* array = "numpy.typing.ArrayLike";

template <class ReadOut, class Wrap>
void bind_array(nb::class_<PyWorld>& world, const char* name, ReadoutKind kind, const std::string& result,
                const ReadOut& read_out, const Wrap& wrap, const char* doc) {
  world.def_prop_ro(
      name, [=](const PyWorld& self) { return self.state->array(kind, 0, read_out, wrap); },
      nb::for_getter(nb::sig(("def " + std::string(name) + "(self) -> " + result).c_str())), doc);
}

/// An array of vectors that can be assigned, for all particles.
template <class ReadOut, class Wrap, class Set>
void bind_vectors(nb::class_<PyWorld>& world, const char* name, ReadoutKind kind, const ReadOut& read_out,
                  const Wrap& wrap, const Set& set, const char* doc) {
  const std::string getter = "def " + std::string(name) + "(self) -> numpy.typing.NDArray[numpy.float32]";
  const std::string setter = "def " + std::string(name) + "(self, value: numpy.typing.ArrayLike, /) -> None";
  world.def_prop_rw(
      name, [=](const PyWorld& self) { return self.state->array(kind, 0, read_out, wrap); },
      [=](const PyWorld& self, nb::handle given) {
        std::vector<Vec3> values;
        read(given, {"World", name}, values);
        self.state->change([&](World& w) { set(w, values); });
      },
      nb::for_getter(nb::sig(getter.c_str())), nb::for_setter(nb::sig(setter.c_str())), doc);
}

/// A call that sets vectors of particles by their ids.
template <class Set>
void bind_set(nb::class_<PyWorld>& world, const char* call, const char* name, const Set& set,
              const char* doc) {
  const std::string text =
      "def " + std::string(call) + "(self, ids: " + array + ", " + name + ": " + array + ") -> None";
  world.def(
      call,
      [=](const PyWorld& self, nb::handle ids, nb::handle given) {
        std::vector<ParticleId> particles;
        std::vector<Vec3> values;
        read(ids, {call, "ids"}, particles);
        read(given, {call, name}, values);
        self.state->change([&](World& w) { set(w, std::span<const ParticleId>(particles), values); });
      },
      nb::arg("ids"), nb::arg(name), nb::sig(text.c_str()), doc);
}

std::string array_type(const char* number) {
  return "numpy.typing.NDArray[numpy." + std::string(number) + "]";
}

/// A member of each element of a read-out.
template <class T, class Element>
nb::object column(std::span<const Element> elements, const void* member, std::size_t width,
                  nb::handle owner) {
  static_assert(sizeof(Element) % sizeof(T) == 0);
  return rows(static_cast<const T*>(member), elements.size(), width, sizeof(Element) / sizeof(T), owner);
}

nb::object owner_of(World& w, const auto& elements) {
  return elements.empty() ? nb::object(nb::none()) : nb::object(kept(w.hold(elements.data())));
}

nb::object ellipsoids(World& w, std::span<const Ellipsoid> all) {
  const nb::object owner = owner_of(w, all);
  const Ellipsoid none, *first = all.empty() ? &none : all.data();
  return make_result("Ellipsoids", column<float>(all, &first->centre, 3, owner),
                     column<float>(all, &first->radii, 3, owner),
                     column<float>(all, &first->rotation, 4, owner));
}

nb::object diffuse(World& w, std::span<const DiffuseParticle> all) {
  const nb::object owner = owner_of(w, all);
  const DiffuseParticle none{}, *first = all.empty() ? &none : all.data();
  return make_result("Diffuse", column<float>(all, &first->position, 3, owner),
                     column<float>(all, &first->velocity, 3, owner),
                     column<float>(all, &first->life, 0, owner),
                     column<uint32_t>(all, &first->kind, 0, owner));
}

void bind_arrays(nb::class_<PyWorld>& world) {
  const auto own = [](World& w, auto values) { return held(w, values); };
  const auto copy = [](World&, auto values) { return copied(values); };
  bind_vectors(
      world, "positions", ReadoutKind::positions, [](World& w) { return w.positions(); }, own,
      [](World& w, std::span<const Vec3> values) { w.set_positions(values); },
      "m, one row a particle, in the order of ids.");
  bind_vectors(
      world, "velocities", ReadoutKind::velocities, [](World& w) { return w.velocities(); }, own,
      [](World& w, std::span<const Vec3> values) { w.set_velocities(values); },
      "m/s, one row a particle, in the order of ids.");
  bind_array(
      world, "ids", ReadoutKind::ids, array_type("uint64"), [](World& w) { return w.ids(); }, copy,
      "Particles are numbered from 0 in the order of their creation.");
  bind_array(
      world, "fluid_indices", ReadoutKind::fluids, array_type("uint32"), [](World& w) { return w.fluids(); },
      own, "Fluid.index of each particle.");
  bind_array(
      world, "density_errors", ReadoutKind::density_errors, array_type("float32"),
      [](World& w) { return w.density_errors(); }, own, "ρ/ρ₀ − 1, at the present positions.");
  bind_array(
      world, "pressures", ReadoutKind::pressures, array_type("float32"),
      [](World& w) { return w.pressures(); }, own, "Pa, of the last substep.");
  bind_array(
      world, "ellipsoids", ReadoutKind::ellipsoids, "meniscus.results.Ellipsoids",
      [](World& w) { return w.ellipsoids(); }, ellipsoids,
      "Ellipsoids whose outsides form the surface of the fluid.");
  bind_array(
      world, "diffuse", ReadoutKind::diffuse, "meniscus.results.Diffuse",
      [](World& w) { return w.diffuse(); }, diffuse,
      "Spray, foam and bubbles, in the order of their creation.");
}

ParticleId add_particles(const PyWorld& self, const Handle<FluidId>& fluid, nb::handle positions,
                         nb::handle velocities) {
  std::vector<Vec3> places, speeds;
  read(positions, {"add_particles", "positions"}, places);
  if (!velocities.is_none()) read(velocities, {"add_particles", "velocities"}, speeds);
  return self.state->change([&](World& w) { return w.add_particles(fluid.id, places, speeds); });
}

void bind_changes(nb::class_<PyWorld>& world) {
  bind_set(
      world, "set_positions", "positions",
      [](World& w, std::span<const ParticleId> ids, std::span<const Vec3> to) { w.set_positions(ids, to); },
      "m, of these particles. An unknown or repeated id is an error. Velocities stay.");
  bind_set(
      world, "set_velocities", "velocities",
      [](World& w, std::span<const ParticleId> ids, std::span<const Vec3> to) { w.set_velocities(ids, to); },
      "m/s, of these particles. An unknown or repeated id is an error.");
  world.def("add_particles", add_particles, nb::arg("fluid"), nb::arg("positions"),
            nb::arg("velocities") = nb::none(),
            nb::sig(("def add_particles(self, fluid: Fluid, positions: " + std::string(array) +
                     ", velocities: " + array + " | None = None) -> int")
                        .c_str()),
            "Adds a particle at each position, m, with its velocity, m/s. Returns the first id; the others "
            "follow it.");
  world.def(
      "remove_particles",
      [](const PyWorld& self, nb::handle ids) {
        std::vector<ParticleId> gone;
        read(ids, {"remove_particles", "ids"}, gone);
        self.state->change([&](World& w) { w.remove_particles(gone); });
      },
      nb::arg("ids"),
      nb::sig(("def remove_particles(self, ids: " + std::string(array) + ") -> None").c_str()),
      "Removes particles by their ids. An unknown id raises NotFoundError.");
  world.def(
      "apply_impulses",
      [](const PyWorld& self, nb::handle ids, nb::handle impulses) {
        std::vector<ParticleId> particles;
        std::vector<Vec3> pushes;
        read(ids, {"apply_impulses", "ids"}, particles);
        read(impulses, {"apply_impulses", "impulses"}, pushes);
        self.state->change(
            [&](World& w) { w.apply_impulses(std::span<const ParticleId>(particles), pushes); });
      },
      nb::arg("ids"), nb::arg("impulses"),
      nb::sig(("def apply_impulses(self, ids: " + std::string(array) + ", impulses: " + array + ") -> None")
                  .c_str()),
      "N·s on each particle, at once.");
}

nb::object surface_mesh(const PyWorld& self, const nb::kwargs& given) {
  SurfaceMeshDef def;
  read_members(def, given, "surface_mesh");
  SurfaceMesh mesh = self.state->measure([&](World& w) { return w.surface_mesh(def); });
  const auto triangles =
      std::make_shared<const std::vector<std::array<uint32_t, 3>>>(std::move(mesh.triangles));
  return make_result("SurfaceMesh", array_of(std::move(mesh.vertices)), array_of(std::move(mesh.normals)),
                     rows(triangles->empty() ? nullptr : triangles->front().data(), triangles->size(), 3, 3,
                          kept(triangles)),
                     array_of(std::move(mesh.velocities)));
}

}  // namespace

void bind_particles(nb::class_<PyWorld>& world) {
  bind_arrays(world);
  bind_changes(world);
  const Description text = describe_call<SurfaceMeshDef>("surface_mesh", "meniscus.results.SurfaceMesh",
                                                         "The surface of the fluid, by marching cubes.");
  world.def("surface_mesh", surface_mesh, nb::sig(text.signature.c_str()), text.doc.c_str());
}

}  // namespace meniscus::python
