// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts and events of the solids of one world of a WorldBatch. They name solids by their places.
#include <vector>

#include "sdk/python/py_batch.h"
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/results.h"

namespace meniscus::python {

namespace {

nb::object solid_contacts(const PyBatch& self, uint32_t world) {
  const auto contacts = self.run([&](WorldBatch& b) { return b.solid_contacts(world); });
  std::vector<int64_t> a, b, shapes;
  std::vector<Vec3> points, normals;
  std::vector<float> distances, impulses;
  for (const SolidContact& c : contacts) {
    a.push_back(place_of(c.a, self.things().bodies.ids));
    b.push_back(place_of(c.b, self.things().bodies.ids));
    shapes.push_back(place_of(c.shape, self.things().shapes.ids));
    points.push_back(c.point);
    normals.push_back(c.normal);
    distances.push_back(c.distance);
    impulses.push_back(c.impulse);
  }
  return make_result("BatchContacts", array_of(std::move(a)), array_of(std::move(b)),
                     array_of(std::move(shapes)), array_of(std::move(points)), array_of(std::move(normals)),
                     array_of(std::move(distances)), array_of(std::move(impulses)));
}

nb::list contact_events(const PyBatch& self, uint32_t world) {
  nb::list list;
  for (const ContactEvent& e : self.run([&](WorldBatch& b) { return b.contact_events(world); }))
    list.append(make_result("BatchContactEvent", place_of(e.a, self.things().bodies.ids),
                            place_of(e.b, self.things().bodies.ids),
                            place_of(e.shape, self.things().shapes.ids), e.began));
  return list;
}

nb::list sleep_events(const PyBatch& self, uint32_t world) {
  nb::list list;
  for (const SleepEvent& e : self.run([&](WorldBatch& b) { return b.sleep_events(world); }))
    list.append(make_result("BatchSleepEvent", place_of(e.body, self.things().bodies.ids), e.awake));
  return list;
}

}  // namespace

void bind_batch_events(nb::class_<PyBatch>& batch) {
  batch.def("solid_contacts", solid_contacts, nb::arg("world"),
            nb::sig("def solid_contacts(self, world: int) -> meniscus.results.BatchContacts"),
            "Pairs of solids of one world that touch or are about to.");
  batch.def("contact_events", contact_events, nb::arg("world"),
            nb::sig("def contact_events(self, world: int) -> list[meniscus.results.BatchContactEvent]"),
            "Solids of one world that began or ceased to touch in its last step.");
  batch.def("sleep_events", sleep_events, nb::arg("world"),
            nb::sig("def sleep_events(self, world: int) -> list[meniscus.results.BatchSleepEvent]"),
            "Bodies of one world that fell asleep or woke in its last step.");
}

}  // namespace meniscus::python
