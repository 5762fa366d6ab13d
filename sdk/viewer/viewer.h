// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The window that shows a world and lets the user grab its objects.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace meniscus::viewer {

/// A scene and its name in the list.
struct SceneSource {
  std::string name;
  std::string path;  ///< of its file
  nlohmann::json document;
};

struct ViewerOptions {
  SceneSource scene;                ///< the first scene
  std::vector<std::string> scenes;  ///< names of the scenes in the list
  /// Reads one of these. It may throw; the window then shows the error.
  std::function<SceneSource(const std::string&)> load;
  std::filesystem::path folder;  ///< of screenshots and videos; it is made with the first one
  int width = 1280, height = 720;
  bool check_opengl = false;  ///< see ViewerEnd::mistakes
};

/// The result of a viewer session.
struct ViewerEnd {
  uint64_t steps = 0;
  double time = 0;  ///< s, of the world at the end
  int screenshots = 0, videos = 0;
  int grabs = 0;     ///< number of grabs by the mouse
  int mistakes = 0;  ///< errors that OpenGL's debug output reported
};

/// Runs until the window is closed. The window shows errors of scenes that cannot be built and of steps that
/// fail. Throws Error(device) without a screen or without OpenGL 4.5.
ViewerEnd run_viewer(const ViewerOptions& options);

}  // namespace meniscus::viewer
