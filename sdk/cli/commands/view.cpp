// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/commands/view.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include "sdk/cli/picture_options.h"
#include "sdk/cli/program.h"
#include "sdk/viewer/viewer.h"

namespace meniscus::cli {

int view_scene(const ViewOptions& options) {
  Scene scene = chosen_scene(options.scene);
  const io::PreviewScene picture =
      picture_scene(scene, {.render = {}, .size = options.size, .camera = options.camera});
  scene.camera = picture.camera;
  const viewer::ViewerEnd end = viewer::run_viewer({
      .scene = scene,
      .name = options.scene.scene,
      .scenes = sample_names(),
      .load =
          [&](const std::string& name) {
            SceneChoice choice = options.scene;
            choice.scene = name;
            choice.overrides.clear();
            return chosen_scene(choice);
          },
      .folder = options.out.empty() ? default_folder(scene) : std::filesystem::path(options.out),
      .width = picture.width,
      .height = picture.height,
      .check_opengl = options.check_opengl,
  });
  fmt::print("{} steps, {:.3f} s simulated, {} screenshots\n", end.steps, end.time, end.screenshots);
  if (end.mistakes == 0) return success;
  spdlog::error("OpenGL found {} mistakes", end.mistakes);
  return run_failed;
}

}  // namespace meniscus::cli
