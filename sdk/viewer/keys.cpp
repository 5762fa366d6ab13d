// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Maps keys to requests.
#include "sdk/viewer/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace meniscus::viewer {
namespace {

render::ParticleView next(render::ParticleView view) {
  const int after = static_cast<int>(view) + 1;
  return static_cast<render::ParticleView>(after % (static_cast<int>(render::ParticleView::pressure) + 1));
}

}  // namespace

void press(int key, Controls& controls, Window& window, bool is_playing) {
  switch (key) {
    case GLFW_KEY_SPACE:
      controls.play = !is_playing;
      break;
    case GLFW_KEY_N:
      controls.step = true;
      break;
    case GLFW_KEY_R:
      controls.reset = true;
      break;
    case GLFW_KEY_F:
      controls.frame_all = true;
      break;
    case GLFW_KEY_V:
      controls.view.particles = next(controls.view.particles);
      break;
    case GLFW_KEY_P:
      controls.screenshot = true;
      break;
    case GLFW_KEY_M:
      controls.movie = !controls.movie;
      break;
    case GLFW_KEY_TAB:
      controls.panels = !controls.panels;
      break;
    case GLFW_KEY_ESCAPE:
      window.close();
      break;
    default:
      break;
  }
}

}  // namespace meniscus::viewer
