// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus check`: reads a scene, builds its world on the CPU, and prints its contents.
#include "sdk/cli/commands/check.h"

#include <spdlog/spdlog.h>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/commands/scene_lookup.h"
#include "sdk/cli/commands/scene_mesh_report.h"
#include "sdk/cli/commands/scene_warnings.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/cli/record/scene_checks.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {

namespace {

using json = nlohmann::ordered_json;

json counts_of(const Scene& scene, const BuiltScene& built) {
  std::size_t vertices = 0, triangles = 0, points = 0;
  for (const ClothId id : built.cloths) {
    vertices += built.world.cloth_positions(id).size();
    triangles += built.world.cloth_triangles(id).size() / 3;
  }
  for (const RopeId id : built.ropes) points += built.world.rope_positions(id).size();
  return {{"particles", built.world.particle_count()},
          {"fluids", scene.fluids.size()},
          {"granulars", scene.granulars.size()},
          {"shapes", scene.shapes.size()},
          {"bodies", built.bodies.size()},
          {"joints", scene.joints.size()},
          {"volumes", scene.volumes.size()},
          {"emitters", scene.emitters.size()},
          {"sinks", scene.sinks.size()},
          {"probes", scene.probes.size()},
          {"force_fields", scene.force_fields.size()},
          {"cloths", scene.cloths.size()},
          {"cloth_vertices", vertices},
          {"cloth_triangles", triangles},
          {"ropes", scene.ropes.size()},
          {"rope_vertices", points},
          {"attachments", scene.attachments.size()},
          {"checks", scene.checks.size()}};
}

json report_of(const Scene& scene, const BuiltScene& built) {
  json warnings = oddities_of(scene, built);
  json meshes = mesh_reports(scene);
  for (const json& mesh : meshes) {
    if (!mesh.at("warning").is_null()) warnings.push_back(mesh.at("warning"));
  }
  return {{"scene", scene.name},
          {"description", scene.description},
          {"counts", counts_of(scene, built)},
          {"particle_spacing_m", without_noise(scene.world.particle_spacing)},
          {"support_radius_m", without_noise(built.world.support_radius())},
          {"frames", scene.frames},
          {"frame_time_s", without_noise(scene.frame_time)},
          {"meshes", std::move(meshes)},
          {"warnings", std::move(warnings)}};
}

std::string text_of(const json& report) {
  const json& counts = report.at("counts");
  const auto count = [&](const char* key) { return counts.at(key).get<std::size_t>(); };
  const auto number = [&](const char* key) { return report.at(key).get<double>(); };
  std::string text = io::plain_text(report.at("scene").get<std::string>()) + ": valid\n";
  const auto description = report.at("description").get<std::string>();
  if (!description.empty()) text += "  " + io::plain_text(description, "\n") + "\n";
  text += fmt::format(
      "  fluids {}, shapes {}, bodies {}, joints {}, volumes {}, emitters {}, sinks {}, probes {}, force "
      "fields "
      "{}\n",
      count("fluids"), count("shapes"), count("bodies"), count("joints"), count("volumes"), count("emitters"),
      count("sinks"), count("probes"), count("force_fields"));
  if (count("cloths") + count("ropes") > 0) {
    text +=
        fmt::format("  cloths {} of {} vertices and {} triangles, ropes {} of {} vertices, attachments {}\n",
                    count("cloths"), count("cloth_vertices"), count("cloth_triangles"), count("ropes"),
                    count("rope_vertices"), count("attachments"));
  }
  text += fmt::format("  particles {}, {:.4g} m apart, support radius {:.4g} m\n", count("particles"),
                      number("particle_spacing_m"), number("support_radius_m"));
  for (const json& mesh : report.at("meshes")) text += mesh_text(mesh);
  return text + fmt::format("  frames {} of {:.4g} s, checks {}\n", report.at("frames").get<int>(),
                            number("frame_time_s"), count("checks"));
}

}  // namespace

int check_scene(const CheckOptions& options) {
  Scene scene = find_scene(options.scene, options.overrides);
  scene.world.device = DeviceChoice::cpu;
  scene.relax_iterations = 0;
  const BuiltScene built = build_scene(scene);
  expect_floor(scene);
  const json report = report_of(scene, built);
  for (const json& warning : report.at("warnings")) spdlog::warn("{}", warning.get<std::string>());
  if (options.json) {
    print_json(report);
  } else {
    fmt::print("{}", text_of(report));
  }
  return success;
}

}  // namespace meniscus::cli
