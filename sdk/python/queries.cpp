// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts, events, rays, overlaps and distances.
#include "sdk/python/arrays.h"
#include "sdk/python/from_python.h"
#include "sdk/python/results.h"
#include "sdk/python/to_python.h"

namespace meniscus::python {

namespace {

/// The thing with this id, or None.
template <class Id>
nb::object thing(const PyWorld& self, Id id) {
  if (id == Id{}) return nb::none();
  return nb::cast(Handle<Id>{self.state, id});
}

template <class Id>
nb::list things(const PyWorld& self, const std::vector<Id>& ids) {
  nb::list list;
  for (const Id id : ids) list.append(thing(self, id));
  return list;
}

/// Its place in the list of World, or -1.
template <class Id>
int64_t place_of(Id id, const std::vector<Id>& ids) {
  const auto at = std::find(ids.begin(), ids.end(), id);
  return at == ids.end() ? -1 : at - ids.begin();
}

nb::object particle_contacts(const PyWorld& self) {
  const auto contacts = self.state->measure([](World& w) { return w.particle_contacts(); });
  std::vector<ParticleId> particles;
  std::vector<int64_t> bodies, shapes, cloths;
  std::vector<Vec3> points, normals, impulses;
  for (const ParticleContact& c : contacts) {
    particles.push_back(c.particle);
    bodies.push_back(place_of(c.body, self.state->bodies.ids));
    shapes.push_back(place_of(c.shape, self.state->shapes.ids));
    cloths.push_back(place_of(c.cloth, self.state->cloths.ids));
    points.push_back(c.point);
    normals.push_back(c.normal);
    impulses.push_back(c.impulse);
  }
  return make_result("ParticleContacts", array_of(std::move(particles)), array_of(std::move(bodies)),
                     array_of(std::move(shapes)), array_of(std::move(cloths)), array_of(std::move(points)),
                     array_of(std::move(normals)), array_of(std::move(impulses)));
}

nb::list solid_contacts(const PyWorld& self) {
  nb::list list;
  for (const SolidContact& c : self.state->look([](World& w) { return w.solid_contacts(); }))
    list.append(make_result("SolidContact", thing(self, c.a), thing(self, c.b), thing(self, c.shape),
                            to_python(c.point), to_python(c.normal), c.distance, c.impulse));
  return list;
}

nb::list contact_events(const PyWorld& self) {
  nb::list list;
  const auto events = self.state->look([](World& w) { return std::vector(w.contact_events()); });
  for (const ContactEvent& e : events)
    list.append(
        make_result("ContactEvent", thing(self, e.a), thing(self, e.b), thing(self, e.shape), e.began));
  return list;
}

nb::list tear_events(const PyWorld& self) {
  nb::list list;
  const auto events = self.state->look([](World& w) { return std::vector(w.tear_events()); });
  for (const TearEvent& e : events)
    list.append(make_result("TearEvent", thing(self, e.cloth), e.copy, e.original));
  return list;
}

nb::object cast_ray(const PyWorld& self, nb::handle start, nb::handle end) {
  Vec3 from, to;
  read(start, {"cast_ray", "start"}, from);
  read(end, {"cast_ray", "end"}, to);
  const std::optional<RayHit> hit =
      self.state->measure([&](World& w) { return w.cast_ray(from, to, {.cloth = false, .ropes = false}); });
  if (!hit) return nb::none();
  return make_result("RayHit", thing(self, hit->body), thing(self, hit->shape), to_python(hit->particle),
                     to_python(hit->point), to_python(hit->normal), hit->distance);
}

nb::object overlaps(const PyWorld& self, const Overlaps& found) {
  return make_result("Overlaps", things(self, found.bodies), things(self, found.shapes),
                     array_of(std::vector(found.particles)));
}

nb::object overlap_ball(const PyWorld& self, nb::handle centre, float radius) {
  Vec3 point;
  read(centre, {"overlap_ball", "centre"}, point);
  return overlaps(self, self.state->measure([&](World& w) { return w.overlap_ball(point, radius); }));
}

nb::object overlap_box(const PyWorld& self, nb::handle pose, nb::handle half_extents) {
  Pose placed;
  Vec3 half;
  read(pose, {"overlap_box", "pose"}, placed);
  read(half_extents, {"overlap_box", "half_extents"}, half);
  return overlaps(self, self.state->measure([&](World& w) { return w.overlap_box(placed, half); }));
}

nb::object solid_distances(const PyWorld& self, nb::handle points, float reach, uint32_t groups,
                           uint32_t mask) {
  std::vector<Vec3> places;
  read(points, {"solid_distances", "points"}, places);
  return array_of(self.state->measure([&](World& w) {
    return w.solid_distances(places, reach, {groups, mask});
  }));
}

}  // namespace

void bind_queries(nb::class_<PyWorld>& world) {
  world.def("particle_contacts", particle_contacts,
            nb::sig("def particle_contacts(self) -> meniscus.results.ParticleContacts"),
            "Contacts of particles in the last substep, with an impulse.");
  world.def("solid_contacts", solid_contacts,
            nb::sig("def solid_contacts(self) -> list[meniscus.results.SolidContact]"),
            "Pairs of solids that touch or are about to.");
  world.def("contact_events", contact_events,
            nb::sig("def contact_events(self) -> list[meniscus.results.ContactEvent]"),
            "Solids that began or ceased to touch in the last step.");
  world.def("tear_events", tear_events, nb::sig("def tear_events(self) -> list[meniscus.results.TearEvent]"),
            "Vertices that tore in two in the last step.");
  world.def("cast_ray", cast_ray,
            nb::sig("def cast_ray(self, start: numpy.typing.ArrayLike, end: numpy.typing.ArrayLike) -> "
                    "meniscus.results.RayHit | None"),
            "The first solid or particle between two points, m. Cloth and ropes do not count.");
  world.def("overlap_ball", overlap_ball,
            nb::sig("def overlap_ball(self, centre: numpy.typing.ArrayLike, radius: float) -> "
                    "meniscus.results.Overlaps"),
            "Solids that overlap a ball, and particles inside, m.");
  world.def("overlap_box", overlap_box,
            nb::sig("def overlap_box(self, pose: Pose | dict[str, typing.Any] | numpy.typing.ArrayLike, "
                    "half_extents: numpy.typing.ArrayLike) -> meniscus.results.Overlaps"),
            "Solids that overlap a box, and particles inside, m.");
  world.def(
      "solid_distances", solid_distances, nb::arg("points"), nb::arg("reach"), nb::arg("groups") = 1u,
      nb::arg("mask") = 0xffffffffu,
      nb::sig("def solid_distances(self, points: numpy.typing.ArrayLike, reach: float, groups: int = 1, "
              "mask: int = 4294967295) -> numpy.typing.NDArray[numpy.float32]"),
      "m, from each point to the nearest solid, negative inside; `reach` where none is nearer.");
}

}  // namespace meniscus::python
