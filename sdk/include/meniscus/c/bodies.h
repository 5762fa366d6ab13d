// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// For C: rigid bodies and joints.
#pragma once

#include <meniscus/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The state of a body: meniscus::BodyState.
typedef struct MeniscusBodyState {
  uint32_t size;                  ///< of this struct
  int32_t awake;                  ///< 0 or 1
  MeniscusPose pose;              ///< of the geometry's frame
  MeniscusVec3 centre_of_mass;    ///< m, world
  MeniscusVec3 velocity;          ///< m/s, of the centre of mass
  MeniscusVec3 angular_velocity;  ///< rad/s
  MeniscusVec3 fluid_force;       ///< N, of all particles on the body, mean over the last step
  MeniscusVec3 fluid_torque;      ///< N·m, about the centre of mass, likewise
} MeniscusBodyState;

/// Mass, centre and inertia of a body: meniscus::BodyMass.
typedef struct MeniscusBodyMass {
  uint32_t size;                ///< of this struct
  float mass;                   ///< kg
  float volume;                 ///< m³
  MeniscusVec3 centre;          ///< m, in the frame of the geometry
  MeniscusVec3 inertia;         ///< kg·m², about the principal axes
  MeniscusQuat principal_axes;  ///< rotation from the principal axes to the frame of the geometry
} MeniscusBodyMass;

/// A mesh file whose surface was rebuilt: meniscus::MeshRepair.
typedef struct MeniscusMeshRepair {
  const char* file;      ///< its path
  float cell_size;       ///< m
  float deviation;       ///< m
  double volume_before;  ///< m³
  double volume;         ///< m³
  uint64_t open_edges;   ///< of the file
  uint64_t odd_edges;    ///< of the file, with more than two faces or two that disagree
  uint64_t crossings;    ///< of the file, pairs of faces that cross
} MeniscusMeshRepair;

/// Reads the state of a body.
MENISCUS_C_API MeniscusStatus meniscus_body_state(const MeniscusWorld* world, MeniscusId body,
                                                  MeniscusBodyState* state);
/// Reads mass, centre and inertia. Kinematic bodies have the defaults.
MENISCUS_C_API MeniscusStatus meniscus_body_mass(const MeniscusWorld* world, MeniscusId body,
                                                 MeniscusBodyMass* mass);
/// The repairs of shapes and bodies so far, in the order of their creation.
MENISCUS_C_API MeniscusStatus meniscus_mesh_repairs(MeniscusWorld* world, const MeniscusMeshRepair** repairs,
                                                    size_t* count);
/// rad, from the pose at creation.
MENISCUS_C_API MeniscusStatus meniscus_hinge_angle(const MeniscusWorld* world, MeniscusId joint,
                                                   double* angle);
/// Places a body. A dynamic body keeps its velocity. A kinematic one then stands still.
MENISCUS_C_API MeniscusStatus meniscus_set_body_pose(MeniscusWorld* world, MeniscusId body,
                                                     MeniscusPose pose);
/// m/s and rad/s, of a dynamic body.
MENISCUS_C_API MeniscusStatus meniscus_set_body_velocity(MeniscusWorld* world, MeniscusId body,
                                                         MeniscusVec3 velocity,
                                                         MeniscusVec3 angular_velocity);
/// N, at a point of the world, on a dynamic body in the next step.
MENISCUS_C_API MeniscusStatus meniscus_apply_force(MeniscusWorld* world, MeniscusId body, MeniscusVec3 force,
                                                   MeniscusVec3 point);
/// N, at the centre of mass, likewise.
MENISCUS_C_API MeniscusStatus meniscus_apply_central_force(MeniscusWorld* world, MeniscusId body,
                                                           MeniscusVec3 force);
/// N·m, on a dynamic body in the next step.
MENISCUS_C_API MeniscusStatus meniscus_apply_torque(MeniscusWorld* world, MeniscusId body,
                                                    MeniscusVec3 torque);
/// N·s, at a point of the world, on a dynamic body at once.
MENISCUS_C_API MeniscusStatus meniscus_apply_impulse(MeniscusWorld* world, MeniscusId body,
                                                     MeniscusVec3 impulse, MeniscusVec3 point);
/// Moves a kinematic body to a pose in `duration` seconds. This replaces its keyframes.
MENISCUS_C_API MeniscusStatus meniscus_move_body(MeniscusWorld* world, MeniscusId body, MeniscusPose target,
                                                 float duration);

#ifdef __cplusplus
}
#endif
