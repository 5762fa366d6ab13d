// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The viewer's keys.
#pragma once

#include "sdk/viewer/controls.h"
#include "sdk/viewer/window.h"

namespace meniscus::viewer {

/// Executes what a key, a GLFW code, asks for.
void press(int key, Controls& controls, Window& window, bool is_playing);

}  // namespace meniscus::viewer
