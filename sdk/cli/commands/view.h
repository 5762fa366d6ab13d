// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus view`.
#pragma once

#include <string>

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

struct ViewOptions {
  SceneChoice scene;
  std::string out, size, camera;  ///< empty: the default that the help states
  bool check_opengl = false;      ///< if OpenGL reports errors, the command ends with one
};

/// `meniscus view`: returns when the window is closed. Throws Error(device) that names what is missing: a
/// screen, OpenGL, or the window in this build.
int view_scene(const ViewOptions& options);

}  // namespace meniscus::cli
