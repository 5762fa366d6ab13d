// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class Body.
#include "sdk/python/thing.h"
#include "sdk/python/things.h"

namespace meniscus::python {

namespace {

using Body = Handle<BodyId>;

constexpr const char* vector_text = "tuple[float, float, float]";

BodyState state_of(const Body& self) {
  return self.state->look([&](World& w) { return w.body_state(self.id); });
}

Vec3 vector_of(nb::handle given, const char* call, const char* argument) {
  Vec3 value;
  read(given, {call, argument}, value);
  return value;
}

/// A property that can be set.
template <class Get, class Set>
void bind_value(nb::class_<Body>& type, const char* name, const char* result, const char* taken,
                const Get& get, const Set& set, const char* doc) {
  const std::string getter = "def " + std::string(name) + "(self) -> " + result;
  const std::string setter = "def " + std::string(name) + "(self, value: " + taken + ", /) -> None";
  type.def_prop_rw(
      name, [get](const Body& self) { return to_python(get(state_of(self))); },
      [set, name](const Body& self, nb::handle given) {
        set(self, given, Place{"Body", name});
      },
      nb::for_getter(nb::sig(getter.c_str())), nb::for_setter(nb::sig(setter.c_str())), doc);
}

void set_pose(const Body& self, const Pose& pose) {
  self.state->change([&](World& w) { w.set_body_pose(self.id, pose); });
}
void set_velocity(const Body& self, Vec3 velocity, Vec3 angular) {
  self.state->change([&](World& w) { w.set_body_velocity(self.id, velocity, angular); });
}

void bind_placement(nb::class_<Body>& type) {
  const char* array = "numpy.typing.ArrayLike";
  bind_value(
      type, "pose", "Pose", "Pose | dict[str, typing.Any] | numpy.typing.ArrayLike",
      [](const BodyState& s) { return s.pose; },
      [](const Body& self, nb::handle given, const Place& place) {
        Pose pose;
        read(given, place, pose);
        set_pose(self, pose);
      },
      "Of the geometry's frame. A body that is placed keeps its velocity; a kinematic one then stands "
      "still.");
  bind_value(
      type, "position", vector_text, array, [](const BodyState& s) { return s.pose.position; },
      [](const Body& self, nb::handle given, const Place& place) {
        Pose pose = state_of(self).pose;
        read(given, place, pose.position);
        set_pose(self, pose);
      },
      "m, of the geometry's frame.");
  bind_value(
      type, "rotation", "tuple[float, float, float, float]", array,
      [](const BodyState& s) { return s.pose.rotation; },
      [](const Body& self, nb::handle given, const Place& place) {
        Pose pose = state_of(self).pose;
        read(given, place, pose.rotation);
        set_pose(self, pose);
      },
      "A unit quaternion (x, y, z, w), of the geometry's frame.");
  bind_value(
      type, "velocity", vector_text, array, [](const BodyState& s) { return s.velocity; },
      [](const Body& self, nb::handle given, const Place& place) {
        Vec3 velocity;
        read(given, place, velocity);
        set_velocity(self, velocity, state_of(self).angular_velocity);
      },
      "m/s, of the centre of mass. Dynamic bodies alone can be set.");
  bind_value(
      type, "angular_velocity", vector_text, array, [](const BodyState& s) { return s.angular_velocity; },
      [](const Body& self, nb::handle given, const Place& place) {
        Vec3 angular;
        read(given, place, angular);
        set_velocity(self, state_of(self).velocity, angular);
      },
      "rad/s. Dynamic bodies alone can be set.");
}

void bind_answers(nb::class_<Body>& type) {
  const auto state = [&](const char* name, const char* result, auto BodyState::*member, const char* doc) {
    bind_answer(
        type, name, result, [member](World& w, BodyId id) { return w.body_state(id).*member; }, doc);
  };
  state("centre_of_mass", vector_text, &BodyState::centre_of_mass, "m, in the world.");
  state("fluid_force", vector_text, &BodyState::fluid_force,
        "N, of all particles on the body, mean over the last step.");
  state("fluid_torque", vector_text, &BodyState::fluid_torque, "N·m, about the centre of mass, likewise.");
  state("awake", "bool", &BodyState::awake, "Whether it is simulated, and not left out as it rests.");
  const auto mass = [&](const char* name, const char* result, auto BodyMass::*member, const char* doc) {
    bind_answer(
        type, name, result, [member](World& w, BodyId id) { return w.body_mass(id).*member; }, doc);
  };
  mass("mass", "float", &BodyMass::mass, "kg; 0 for kinematic bodies.");
  mass("volume", "float", &BodyMass::volume, "m³.");
  mass("inertia", vector_text, &BodyMass::inertia, "kg·m², about the principal axes.");
}

void bind_forces(nb::class_<Body>& type) {
  type.def(
      "apply_force",
      [](const Body& self, nb::handle force, nb::handle point) {
        const Vec3 f = vector_of(force, "apply_force", "force");
        const Vec3 p =
            point.is_none() ? state_of(self).centre_of_mass : vector_of(point, "apply_force", "point");
        self.state->change([&](World& w) { w.apply_force(self.id, f, p); });
      },
      nb::arg("force"), nb::arg("point") = nb::none(),
      nb::sig(
          "def apply_force(self, force: numpy.typing.ArrayLike, point: numpy.typing.ArrayLike | None = None) "
          "-> None"),
      "N, at a point of the world, m; by default at the centre of mass. For the next step alone.");
  type.def(
      "apply_torque",
      [](const Body& self, nb::handle torque) {
        const Vec3 t = vector_of(torque, "apply_torque", "torque");
        self.state->change([&](World& w) { w.apply_torque(self.id, t); });
      },
      nb::arg("torque"), nb::sig("def apply_torque(self, torque: numpy.typing.ArrayLike) -> None"),
      "N·m. For the next step alone.");
  type.def(
      "apply_impulse",
      [](const Body& self, nb::handle impulse, nb::handle point) {
        const Vec3 j = vector_of(impulse, "apply_impulse", "impulse");
        const Vec3 p =
            point.is_none() ? state_of(self).centre_of_mass : vector_of(point, "apply_impulse", "point");
        self.state->change([&](World& w) { w.apply_impulse(self.id, j, p); });
      },
      nb::arg("impulse"), nb::arg("point") = nb::none(),
      nb::sig(
          "def apply_impulse(self, impulse: numpy.typing.ArrayLike, point: numpy.typing.ArrayLike | None = "
          "None) -> None"),
      "N·s, at once, at a point of the world, m; by default at the centre of mass.");
  type.def(
      "move_to",
      [](const Body& self, nb::handle target, float duration) {
        Pose pose;
        read(target, {"move_to", "pose"}, pose);
        self.state->change([&](World& w) { w.move_body(self.id, pose, duration); });
      },
      nb::arg("pose"), nb::arg("duration"),
      nb::sig("def move_to(self, pose: Pose | dict[str, typing.Any] | numpy.typing.ArrayLike, duration: "
              "float) -> "
              "None"),
      "Moves a kinematic body to a pose in so many seconds, at a constant rate. This replaces its "
      "keyframes.");
}

}  // namespace

void bind_body(nb::module_& module, nb::class_<PyWorld>& world) {
  nb::class_<Body> type = bind_thing(module, world, "body", "bodies", &Things::bodies);
  bind_creation<BodyDef>(world, "add_body", &Things::bodies, &World::create_body,
                         "Adds a rigid body. Raises MeshError where a mesh is no closed, simple surface.");
  bind_destruction(type, &Things::bodies, &World::destroy_body,
                   "Removes it, and its joints, attachments, emitters and sinks.");
  bind_placement(type);
  bind_surfaces(type);
  bind_answers(type);
  bind_forces(type);
}

}  // namespace meniscus::python
