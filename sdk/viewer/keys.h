// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/viewer/controls.h"
#include "sdk/viewer/window.h"

namespace meniscus::viewer {

/// What a key, one of GLFW's, asks for.
void press(int key, Controls& controls, Window& window, bool is_playing);

}  // namespace meniscus::viewer
