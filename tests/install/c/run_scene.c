/* SPDX-FileCopyrightText: 2026 The Meniscus authors */
/* SPDX-License-Identifier: MIT */
/* */
/* run_scene_c FILE FRAMES: reads a scene file, builds it, and steps it on one thread of the CPU. */
#include <meniscus/meniscus_c.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(const char* what) {
  fprintf(stderr, "%s: %s\n", what, meniscus_last_error());
  return 1;
}

static int step(MeniscusWorld* world, float dt, long frames) {
  MeniscusStepReport report;
  MeniscusDiagnostics diagnostics;
  uint64_t hash;
  long frame;
  report.size = sizeof report;
  diagnostics.size = sizeof diagnostics;
  for (frame = 0; frame < frames; ++frame) {
    if (meniscus_step(world, dt, &report)) return fail("step");
  }
  if (meniscus_diagnostics(world, &diagnostics) || meniscus_state_hash(world, &hash)) return fail("diagnostics");
  if (diagnostics.non_finite > 0) return fprintf(stderr, "values are not finite\n"), 1;
  printf("%lu particles, hash %08lx%08lx\n", (unsigned long)diagnostics.particles, (unsigned long)(hash >> 32),
         (unsigned long)(hash & 0xffffffffu));
  return 0;
}

int main(int count, char** arguments) {
  const char* const overrides[] = {"world.device=cpu", "world.threads=1"};
  MeniscusScene* scene;
  MeniscusSceneInfo info;
  MeniscusWorld* world;
  int result;
  if (count != 3) return fprintf(stderr, "run_scene_c FILE FRAMES\n"), 2;
  info.size = sizeof info;
  if (meniscus_scene_read(arguments[1], overrides, 2, &scene)) return fail("read");
  if (meniscus_scene_info(scene, &info)) return fail("info");
  if (meniscus_scene_check(scene)) return fail("check");
  if (meniscus_scene_build(scene, &world)) return fail("build");
  result = step(world, info.frame_time, strtol(arguments[2], NULL, 10));
  meniscus_world_destroy(world);
  meniscus_scene_destroy(scene);
  return result;
}
