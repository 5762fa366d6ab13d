// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// An OpenGL context without a screen.
#pragma once

#include <memory>
#include <string>

namespace meniscus::render {

enum class EglDevices {
  all,       ///< GPUs first, then Mesa's rasteriser on the CPU
  software,  ///< Mesa's rasteriser alone
};

/// OpenGL 4.5 without a screen, through EGL. The context is current on this thread while the object exists.
class EglContext {
 public:
  /// Takes the first device with such a context. Throws Error(device) that names what is missing.
  explicit EglContext(EglDevices devices = EglDevices::all);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// The name that the device reports.
  std::string renderer() const;

 private:
  struct Names;
  std::unique_ptr<Names> names_;
};

}  // namespace meniscus::render
