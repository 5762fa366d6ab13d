// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A program against the installed SDK: reads a scene file, builds it and makes one step.
#include <meniscus/scene.h>

#include <cstdio>

int main(int, char** arguments) try {
  const meniscus::Scene scene = meniscus::read_scene(arguments[1]);
  meniscus::BuiltScene built = meniscus::build_scene(scene);
  built.world.step(scene.frame_time);
  std::printf("%s: %zu particles\n", scene.name.c_str(), built.world.particle_count());
} catch (const meniscus::SceneError& error) {
  std::fprintf(stderr, "%s at %s; %s\n", error.file().c_str(), error.path().c_str(), error.fix().c_str());
  return 1;
}
