// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The bodies of WorldBatch.
#include <nanobind/ndarray.h>

#include <vector>

#include "sdk/python/py_batch.h"
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/values/results.h"

namespace meniscus::python {

namespace {

using Body = Handle<BodyId>;

template <class T>
T taken(nb::handle given, const char* call, const char* argument) {
  T value;
  read(given, {call, argument}, value);
  return value;
}

/// worlds × bodies × width, of numbers that follow one another in `values`.
nb::object body_array(std::vector<float> values, std::size_t worlds, std::size_t width) {
  const auto owner = std::make_shared<const std::vector<float>>(std::move(values));
  const std::size_t shape[] = {worlds, owner->size() / worlds / width, width};
  return nb::cast(nb::ndarray<nb::numpy, const float>(owner->data(), 3, shape, kept(owner)));
}

nb::object body_states(const PyBatch& self) {
  std::vector<float> places, rotations, velocities, turns, forces, torques;
  const auto add = [](std::vector<float>& to, Vec3 v) { to.insert(to.end(), {v.x, v.y, v.z}); };
  const std::size_t worlds = self.run([&](WorldBatch& b) {
    for (const BodyState& s : b.body_states()) {
      const Quat q = s.pose.rotation;
      add(places, s.pose.position);
      rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
      add(velocities, s.velocity);
      add(turns, s.angular_velocity);
      add(forces, s.fluid_force);
      add(torques, s.fluid_torque);
    }
    return std::size_t{b.worlds()};
  });
  return make_result("BatchBodies", body_array(std::move(places), worlds, 3),
                     body_array(std::move(rotations), worlds, 4),
                     body_array(std::move(velocities), worlds, 3), body_array(std::move(turns), worlds, 3),
                     body_array(std::move(forces), worlds, 3), body_array(std::move(torques), worlds, 3));
}

void bind_placement(nb::class_<PyBatch>& batch) {
  batch.def(
      "set_body_pose",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle pose) {
        const Pose to = taken<Pose>(pose, "set_body_pose", "pose");
        self.run([&](WorldBatch& b) { b.set_body_pose(world, body.id, to); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("pose"),
      nb::sig("def set_body_pose(self, world: int, body: Body, pose: Pose | dict[str, typing.Any] | "
              "numpy.typing.ArrayLike) -> None"),
      "Places a body of one world. The body is that of the archetype.");
  batch.def(
      "set_body_velocity",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle velocity, nb::handle angular) {
        const Vec3 v = taken<Vec3>(velocity, "set_body_velocity", "velocity");
        const Vec3 turn = taken<Vec3>(angular, "set_body_velocity", "angular_velocity");
        self.run([&](WorldBatch& b) { b.set_body_velocity(world, body.id, v, turn); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("velocity"), nb::arg("angular_velocity"),
      nb::sig("def set_body_velocity(self, world: int, body: Body, velocity: numpy.typing.ArrayLike, "
              "angular_velocity: numpy.typing.ArrayLike) -> None"),
      "m/s and rad/s, of a dynamic body of one world.");
  batch.def(
      "move_body",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle pose, float duration) {
        const Pose to = taken<Pose>(pose, "move_body", "pose");
        self.run([&](WorldBatch& b) { b.move_body(world, body.id, to, duration); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("pose"), nb::arg("duration"),
      nb::sig("def move_body(self, world: int, body: Body, pose: Pose | dict[str, typing.Any] | "
              "numpy.typing.ArrayLike, duration: float) -> None"),
      "Moves a kinematic body of one world to a pose in so many seconds, at a constant rate.");
}

void bind_forces(nb::class_<PyBatch>& batch) {
  batch.def(
      "apply_force",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle force, nb::handle point) {
        const Vec3 f = taken<Vec3>(force, "apply_force", "force");
        if (point.is_none()) return self.run([&](WorldBatch& b) { b.apply_force(world, body.id, f); });
        const Vec3 p = taken<Vec3>(point, "apply_force", "point");
        self.run([&](WorldBatch& b) { b.apply_force(world, body.id, f, p); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("force"), nb::arg("point") = nb::none(),
      nb::sig("def apply_force(self, world: int, body: Body, force: numpy.typing.ArrayLike, point: "
              "numpy.typing.ArrayLike | None = None) -> None"),
      "N, at a point of the world, m; by default at the centre of mass. For the next step alone.");
  batch.def(
      "apply_torque",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle torque) {
        const Vec3 t = taken<Vec3>(torque, "apply_torque", "torque");
        self.run([&](WorldBatch& b) { b.apply_torque(world, body.id, t); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("torque"),
      nb::sig("def apply_torque(self, world: int, body: Body, torque: numpy.typing.ArrayLike) -> None"),
      "N·m. For the next step alone.");
  batch.def(
      "apply_impulse",
      [](const PyBatch& self, uint32_t world, const Body& body, nb::handle impulse, nb::handle point) {
        const Vec3 j = taken<Vec3>(impulse, "apply_impulse", "impulse");
        const Vec3 p = taken<Vec3>(point, "apply_impulse", "point");
        self.run([&](WorldBatch& b) { b.apply_impulse(world, body.id, j, p); });
      },
      nb::arg("world"), nb::arg("body"), nb::arg("impulse"), nb::arg("point"),
      nb::sig("def apply_impulse(self, world: int, body: Body, impulse: numpy.typing.ArrayLike, point: "
              "numpy.typing.ArrayLike) -> None"),
      "N·s, at once, at a point of the world, m.");
}

}  // namespace

void bind_batch_bodies(nb::class_<PyBatch>& batch) {
  batch.def_prop_ro(
      "body_count",
      [](const PyBatch& self) { return self.run([](WorldBatch& b) { return b.body_count(); }); },
      "Of each world.");
  batch.def_prop_ro("bodies", &body_states,
                    nb::for_getter(nb::sig("def bodies(self) -> meniscus.results.BatchBodies")),
                    "Where the bodies of all worlds are, and how they move.");
  bind_placement(batch);
  bind_forces(batch);
}

}  // namespace meniscus::python
