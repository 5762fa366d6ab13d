// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The window in which a world is watched, and taken hold of.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace meniscus::viewer {

/// A scene, and what its list calls it.
struct SceneSource {
  std::string name;
  std::string path;  ///< of its file
  nlohmann::json document;
};

struct ViewerOptions {
  SceneSource scene;                ///< what it opens with
  std::vector<std::string> scenes;  ///< what the list offers, by name
  /// Reads one of these. May throw, which the window shows.
  std::function<SceneSource(const std::string&)> load;
  std::filesystem::path folder;  ///< of screenshots, made where there are any
  int width = 1280, height = 720;
  bool check_opengl = false;  ///< see ViewerEnd::mistakes
};

/// What came of it.
struct ViewerEnd {
  uint64_t steps = 0;
  double time = 0;  ///< s, of the world at the end
  int screenshots = 0;
  int grabs = 0;     ///< how often the mouse took hold of something
  int mistakes = 0;  ///< errors that OpenGL's own check found
};

/// Returns when the window is closed. A scene that cannot be built, or a step that fails, is told in the
/// window. Throws Error(device) where there is no screen or no OpenGL 4.5.
ViewerEnd run_viewer(const ViewerOptions& options);

}  // namespace meniscus::viewer
