/* SPDX-FileCopyrightText: 2026 The Meniscus authors */
/* SPDX-License-Identifier: MIT */
/* */
/* Three scenes in C99: water in a tank with a body, cloth over a ball, an emitter and a sink. */
#include "tests/unit/sdk/c/c_scenes.h"

static MeniscusVec3 vec3(float x, float y, float z) {
  MeniscusVec3 v;
  v.x = x, v.y = y, v.z = z;
  return v;
}

/* Ends the function at the first failure. */
#define TRY(call)                                \
  do {                                           \
    const MeniscusStatus status_ = (call);       \
    if (status_ != MENISCUS_OK) return status_;  \
  } while (0)

/* Goes on as long as nothing has failed, so that the end of the function is reached. */
#define THEN(call) \
  if (status == MENISCUS_OK) status = (call)

/* Creates the object of a definition, unless setting it has failed, and destroys the definition. */
static MeniscusStatus finish(MeniscusWorld* world, MeniscusDef* def, MeniscusStatus status, MeniscusId* id) {
  THEN(meniscus_create(world, def, id));
  meniscus_def_destroy(def);
  return status;
}

static MeniscusStatus make_world(const char* device, MeniscusWorld** world) {
  MeniscusStatus status = MENISCUS_OK;
  MeniscusDef* def;
  TRY(meniscus_def_create(MENISCUS_WORLD_DEF, &def));
  THEN(meniscus_def_set_text(def, "device", device));
  THEN(meniscus_def_set_number(def, "threads", 2));
  THEN(meniscus_def_set_number(def, "particle_spacing", 0.05));
  THEN(meniscus_def_set_number(def, "density.warm_start", 0.25));
  THEN(meniscus_world_create(def, world));
  meniscus_def_destroy(def);
  return status;
}

static MeniscusStatus make_fluid(MeniscusWorld* world, MeniscusId* id) {
  MeniscusStatus status = MENISCUS_OK;
  MeniscusDef* def;
  TRY(meniscus_def_create(MENISCUS_FLUID_DEF, &def));
  THEN(meniscus_def_set_number(def, "dynamic_viscosity", 0.5));
  return finish(world, def, status, id);
}

static MeniscusStatus fill_tank(MeniscusWorld* world, MeniscusId* body) {
  MeniscusStatus status = MENISCUS_OK;
  MeniscusDef* def;
  MeniscusId id, water;
  TRY(meniscus_def_create(MENISCUS_SHAPE_DEF, &def));
  THEN(meniscus_def_set_text(def, "name", "tank"));
  THEN(meniscus_def_set_text(def, "geometry", "container"));
  THEN(meniscus_def_set_vector(def, "geometry.half_extents", vec3(0.4f, 0.4f, 0.3f)));
  THEN(meniscus_def_resize(def, "geometry.openings", 1));
  THEN(meniscus_def_set_text(def, "geometry.openings[0].face", "y_high"));
  TRY(finish(world, def, status, &id));

  TRY(meniscus_def_create(MENISCUS_BODY_DEF, &def));
  THEN(meniscus_def_set_text(def, "name", "crate"));
  THEN(meniscus_def_set_vector(def, "geometry.half_extents", vec3(0.1f, 0.1f, 0.1f)));
  THEN(meniscus_def_set_vector(def, "pose.position", vec3(0, 0.2f, 0)));
  THEN(meniscus_def_set_number(def, "mass", 4));
  THEN(meniscus_def_set_number(def, "surface.friction", 0.2));
  TRY(finish(world, def, status, body));

  TRY(make_fluid(world, &water));
  TRY(meniscus_def_create(MENISCUS_FLUID_VOLUME_DEF, &def));
  THEN(meniscus_def_set_id(def, "fluid", water));
  THEN(meniscus_def_set_vector(def, "region.lower", vec3(-0.4f, -0.4f, -0.3f)));
  THEN(meniscus_def_set_vector(def, "region.upper", vec3(0.4f, 0.0f, 0.3f)));
  THEN(meniscus_add_fluid(world, def, NULL));
  meniscus_def_destroy(def);
  return status;
}

static MeniscusStatus drape(MeniscusWorld* world, MeniscusId* cloth) {
  MeniscusStatus status = MENISCUS_OK;
  MeniscusDef* def;
  MeniscusId ball;
  TRY(meniscus_def_create(MENISCUS_SHAPE_DEF, &def));
  THEN(meniscus_def_set_text(def, "geometry", "sphere"));
  THEN(meniscus_def_set_number(def, "geometry.radius", 0.3));
  THEN(meniscus_def_set_number(def, "surface.friction", 0.5));
  TRY(finish(world, def, status, &ball));

  TRY(meniscus_def_create(MENISCUS_CLOTH_DEF, &def));
  THEN(meniscus_def_set_number(def, "geometry.columns", 17));
  THEN(meniscus_def_set_number(def, "geometry.rows", 17));
  THEN(meniscus_def_set_vector(def, "pose.position", vec3(0, 0.35f, 0)));
  THEN(meniscus_def_set_number(def, "fabric.density", 0.3));
  THEN(meniscus_def_set_text(def, "fabric.stretch_model", "triangles"));
  THEN(meniscus_def_set_flag(def, "tethers", 0));
  return finish(world, def, status, cloth);
}

static MeniscusStatus add_flow(MeniscusWorld* world, MeniscusId* emitter, MeniscusId* sink) {
  MeniscusStatus status = MENISCUS_OK;
  MeniscusDef* def;
  MeniscusId water;
  MeniscusQuat down;
  down.x = 1, down.y = 0, down.z = 0, down.w = 0;
  TRY(make_fluid(world, &water));
  TRY(meniscus_def_create(MENISCUS_EMITTER_DEF, &def));
  THEN(meniscus_def_set_id(def, "fluid", water));
  THEN(meniscus_def_set_number(def, "opening.radius", 0.15));
  THEN(meniscus_def_set_rotation(def, "pose.rotation", down));
  THEN(meniscus_def_set_number(def, "speed", 2));
  THEN(meniscus_def_set_number(def, "most_particles", 1000));
  TRY(finish(world, def, status, emitter));

  TRY(meniscus_def_create(MENISCUS_SINK_DEF, &def));
  THEN(meniscus_def_set_text(def, "region", "half_space"));
  THEN(meniscus_def_set_number(def, "region.offset", -0.3));
  return finish(world, def, status, sink);
}

/* Destroys a world that could not be filled. */
static MeniscusStatus filled(MeniscusStatus status, MeniscusWorld** world) {
  if (status != MENISCUS_OK) {
    meniscus_world_destroy(*world);
    *world = NULL;
  }
  return status;
}

MeniscusStatus c_tank_with_body(const char* device, MeniscusWorld** world, MeniscusId* body) {
  *world = NULL;
  TRY(make_world(device, world));
  return filled(fill_tank(*world, body), world);
}

MeniscusStatus c_cloth_over_ball(const char* device, MeniscusWorld** world, MeniscusId* cloth) {
  *world = NULL;
  TRY(make_world(device, world));
  return filled(drape(*world, cloth), world);
}

MeniscusStatus c_emitter_and_sink(const char* device, MeniscusWorld** world, MeniscusId* emitter,
                                  MeniscusId* sink) {
  *world = NULL;
  TRY(make_world(device, world));
  return filled(add_flow(*world, emitter, sink), world);
}
