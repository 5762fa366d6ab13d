// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Continues a run from a snapshot.
#include "sdk/cli/commands/resume.h"

#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace meniscus::cli {

namespace {

void expect_count(const char* what, std::size_t found, std::size_t expected, const std::string& file) {
  if (found == expected) return;
  throw Error(ErrorCode::invalid_argument,
              fmt::format("{} holds {} {}, and the scene has {}: it is of another scene", file, found, what,
                          expected));
}

}  // namespace

BuiltScene resume_scene(const Scene& scene, const std::string& file) {
  BuiltScene built{.world =
                       World::load(file, {scene.world.device, scene.world.threads, scene.world.cuda_device})};
  const World& world = built.world;
  built.fluids = world.fluid_ids();
  built.shapes = world.shape_ids();
  built.bodies = world.body_ids();
  built.joints = world.joint_ids();
  built.cloths = world.cloth_ids();
  built.ropes = world.rope_ids();
  built.attachments = world.attachment_ids();
  built.emitters = world.emitter_ids();
  built.sinks = world.sink_ids();
  built.probes = world.probe_ids();
  built.force_fields = world.force_field_ids();
  expect_count("fluids", built.fluids.size(), scene.fluids.size() + scene.granulars.size(), file);
  expect_count("shapes", built.shapes.size(), scene.shapes.size(), file);
  expect_count("bodies", built.bodies.size(), bodies_of(scene).size(), file);
  expect_count("joints", built.joints.size(), scene.joints.size(), file);
  expect_count("pieces of cloth", built.cloths.size(), scene.cloths.size(), file);
  expect_count("ropes", built.ropes.size(), scene.ropes.size(), file);
  expect_count("attachments", built.attachments.size(), scene.attachments.size(), file);
  expect_count("emitters", built.emitters.size(), scene.emitters.size(), file);
  expect_count("sinks", built.sinks.size(), scene.sinks.size(), file);
  expect_count("probes", built.probes.size(), scene.probes.size(), file);
  expect_count("force fields", built.force_fields.size(), scene.force_fields.size(), file);
  return built;
}

int frame_of(const World& world, const Scene& scene) {
  return static_cast<int>(std::lround(world.time() / double{scene.frame_time}));
}

std::filesystem::path snapshot_path(const std::filesystem::path& folder, int frame) {
  return folder / fmt::format("snapshot_{:05}.menisnap", frame);
}

}  // namespace meniscus::cli
