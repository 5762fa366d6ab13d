// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies and joints of C.
#include <meniscus/c/bodies.h>

#include "sdk/c/handles.h"

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_body_state(const MeniscusWorld* world, MeniscusId body, MeniscusBodyState* state) {
  return guarded([&] {
    const BodyState s = world_of(world).body_state(in_cpp<BodyId>(body));
    write_result(state, {0, s.awake ? 1 : 0, in_c(s.pose), in_c(s.centre_of_mass), in_c(s.velocity),
                         in_c(s.angular_velocity), in_c(s.fluid_force), in_c(s.fluid_torque)});
  });
}

MeniscusStatus meniscus_body_mass(const MeniscusWorld* world, MeniscusId body, MeniscusBodyMass* mass) {
  return guarded([&] {
    const BodyMass m = world_of(world).body_mass(in_cpp<BodyId>(body));
    write_result(mass, {0, m.mass, m.volume, in_c(m.centre), in_c(m.inertia), in_c(m.principal_axes)});
  });
}

MeniscusStatus meniscus_mesh_repairs(MeniscusWorld* world, const MeniscusMeshRepair** repairs,
                                     size_t* count) {
  return guarded([&] {
    std::vector<MeniscusMeshRepair>& list = required(world, "world").repairs;
    list.clear();
    for (const MeshRepair& r : world->world.mesh_repairs())
      list.push_back({r.file.c_str(), r.cell_size, r.deviation, r.volume_before, r.volume, r.open_edges,
                      r.odd_edges, r.crossings});
    write_array(repairs, count, list);
  });
}

MeniscusStatus meniscus_hinge_angle(const MeniscusWorld* world, MeniscusId joint, double* angle) {
  return guarded([&] { required(angle, "angle") = world_of(world).hinge_angle(in_cpp<JointId>(joint)); });
}

MeniscusStatus meniscus_set_body_pose(MeniscusWorld* world, MeniscusId body, MeniscusPose pose) {
  return guarded([&] { world_of(world).set_body_pose(in_cpp<BodyId>(body), in_cpp(pose)); });
}

MeniscusStatus meniscus_set_body_velocity(MeniscusWorld* world, MeniscusId body, MeniscusVec3 velocity,
                                          MeniscusVec3 angular_velocity) {
  return guarded([&] {
    world_of(world).set_body_velocity(in_cpp<BodyId>(body), in_cpp(velocity), in_cpp(angular_velocity));
  });
}

MeniscusStatus meniscus_apply_force(MeniscusWorld* world, MeniscusId body, MeniscusVec3 force,
                                    MeniscusVec3 point) {
  return guarded([&] { world_of(world).apply_force(in_cpp<BodyId>(body), in_cpp(force), in_cpp(point)); });
}

MeniscusStatus meniscus_apply_central_force(MeniscusWorld* world, MeniscusId body, MeniscusVec3 force) {
  return guarded([&] { world_of(world).apply_force(in_cpp<BodyId>(body), in_cpp(force)); });
}

MeniscusStatus meniscus_apply_torque(MeniscusWorld* world, MeniscusId body, MeniscusVec3 torque) {
  return guarded([&] { world_of(world).apply_torque(in_cpp<BodyId>(body), in_cpp(torque)); });
}

MeniscusStatus meniscus_apply_impulse(MeniscusWorld* world, MeniscusId body, MeniscusVec3 impulse,
                                      MeniscusVec3 point) {
  return guarded(
      [&] { world_of(world).apply_impulse(in_cpp<BodyId>(body), in_cpp(impulse), in_cpp(point)); });
}

MeniscusStatus meniscus_move_body(MeniscusWorld* world, MeniscusId body, MeniscusPose target,
                                  float duration) {
  return guarded([&] { world_of(world).move_body(in_cpp<BodyId>(body), in_cpp(target), duration); });
}
