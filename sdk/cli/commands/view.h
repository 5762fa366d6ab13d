// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

struct ViewOptions {
  SceneChoice scene;
  std::string out, size, camera;  ///< empty: as the help says
  bool check_opengl = false;      ///< errors that OpenGL reports end the command with one
};

/// `meniscus view`: returns when the window is closed. Throws Error(device) that says what is missing where
/// there is no screen or OpenGL, or where the window was not built.
int view_scene(const ViewOptions& options);

}  // namespace meniscus::cli
