// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts and events of the last step.
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/results.h"
#include "sdk/python/values/to_python.h"

namespace meniscus::python {

namespace {

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

nb::list sleep_events(const PyWorld& self) {
  nb::list list;
  const auto events = self.state->look([](World& w) { return std::vector(w.sleep_events()); });
  for (const SleepEvent& e : events) list.append(make_result("SleepEvent", thing(self, e.body), e.awake));
  return list;
}

nb::object flow_events(const PyWorld& self) {
  const auto events = self.state->look([](World& w) { return std::vector(w.flow_events()); });
  std::vector<int64_t> emitters, sinks;
  std::vector<ParticleId> particles;
  for (const FlowEvent& e : events) {
    emitters.push_back(place_of(e.emitter, self.state->emitters.ids));
    sinks.push_back(place_of(e.sink, self.state->sinks.ids));
    particles.push_back(e.particle);
  }
  return make_result("FlowEvents", array_of(std::move(emitters)), array_of(std::move(sinks)),
                     array_of(std::move(particles)));
}

}  // namespace

void bind_events(nb::class_<PyWorld>& world) {
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
  world.def("sleep_events", sleep_events,
            nb::sig("def sleep_events(self) -> list[meniscus.results.SleepEvent]"),
            "Bodies that fell asleep or woke since the end of the step before.");
  world.def("flow_events", flow_events, nb::sig("def flow_events(self) -> meniscus.results.FlowEvents"),
            "Particles that emitters made and sinks removed in the last step, those of sinks first.");
}

}  // namespace meniscus::python
