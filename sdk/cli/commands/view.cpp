// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus view`: opens the window with the chosen scene.
#include "sdk/cli/commands/view.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/output/picture_options.h"
#include "sdk/viewer/viewer.h"

namespace meniscus::cli {

namespace {

viewer::SceneSource source_of(const SceneChoice& choice) {
  return {.name = choice.scene, .path = scene_path(choice.scene), .document = chosen_document(choice)};
}

/// Sets the camera in the document, so that later builds of the scene use it too.
void set_camera(nlohmann::json& document, const SceneCamera& camera) {
  const auto json_of = [](Vec3 v) { return nlohmann::json{v.x, v.y, v.z}; };
  document["camera"] = {{"position", json_of(camera.position)},
                        {"target", json_of(camera.target)},
                        {"field_of_view", camera.field_of_view}};
}

}  // namespace

int view_scene(const ViewOptions& options) {
  const Scene scene = chosen_scene(options.scene);
  PictureOptions picture_options;
  picture_options.size = options.size;
  picture_options.camera = options.camera;
  const io::PreviewScene picture = picture_scene(scene, picture_options);
  viewer::SceneSource first = source_of(options.scene);
  if (!options.camera.empty()) set_camera(first.document, *picture.camera);
  const viewer::ViewerEnd end = viewer::run_viewer({
      .scene = first,
      .scenes = sample_names(),
      .load =
          [&](const std::string& name) {
            SceneChoice choice = options.scene;
            choice.scene = name;
            choice.overrides.clear();  // they belong to the first scene
            return source_of(choice);
          },
      .folder = options.out.empty() ? default_folder(scene) : std::filesystem::path(options.out),
      .width = picture.width,
      .height = picture.height,
      .check_opengl = options.check_opengl,
  });
  fmt::print("{} steps, {:.3f} s simulated, {} grabs, {} screenshots, {} videos\n", end.steps, end.time,
             end.grabs, end.screenshots, end.videos);
  if (end.mistakes == 0) return success;
  spdlog::error("OpenGL found {} mistakes", end.mistakes);
  return run_failed;
}

}  // namespace meniscus::cli
