// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

namespace meniscus::render {

enum class EglDevices {
  all,       ///< GPUs first, then Mesa's rasteriser on the CPU
  software,  ///< that rasteriser alone
};

/// OpenGL 4.5 without a screen, through EGL; current on this thread as long as it lives.
class EglContext {
 public:
  /// Takes the first device that gives such a context. Throws Error(device) that says what is missing.
  explicit EglContext(EglDevices devices = EglDevices::all);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// What draws, as it calls itself.
  std::string renderer() const;

 private:
  struct Names;
  std::unique_ptr<Names> names_;
};

}  // namespace meniscus::render
