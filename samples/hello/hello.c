/* SPDX-FileCopyrightText: 2026 The Meniscus authors
 * SPDX-License-Identifier: MIT
 * A drop of water falls for a quarter of a second, in C. Link meniscus_c. */
#include <meniscus/meniscus_c.h>
#include <stdio.h>

int main(void) {
  MeniscusWorld* world;
  MeniscusDef *fluid, *drop;
  MeniscusId water;
  const MeniscusVec3* at;
  size_t n;
  int bad = meniscus_world_create(NULL, &world) || meniscus_def_create(MENISCUS_FLUID_DEF, &fluid) ||
            meniscus_create(world, fluid, &water) || meniscus_def_create(MENISCUS_FLUID_VOLUME_DEF, &drop) ||
            meniscus_def_set_id(drop, "fluid", water) || meniscus_def_set_text(drop, "region", "ball") ||
            meniscus_add_fluid(world, drop, NULL);
  for (int k = 0; !bad && k < 15; ++k) bad = meniscus_step(world, 1.0f / 60, NULL);
  if (bad || meniscus_positions(world, &at, &n)) return fprintf(stderr, "%s\n", meniscus_last_error()), 1;
  return printf("%u particles, the first at y = %.2f m\n", (unsigned)n, at[0].y) < 0;
}
