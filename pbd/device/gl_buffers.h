// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pbd/device/device.h"

namespace meniscus::pbd {

struct LentMemory {
  void* data;
  size_t bytes;
};

/// Buffers of OpenGL's in memory that CUDA's kernels use as well. To be made, lent and destroyed with
/// OpenGL's context current.
class GlBuffers {
 public:
  virtual ~GlBuffers() = default;

  /// For what is launched on this device of CUDA from here on, after all that OpenGL was told before.
  virtual std::vector<LentMemory> lend(Device& device) = 0;
  /// What OpenGL is told from here on comes after what was launched.
  virtual void give_back(Device& device) = 0;
};

/// By their names; they must keep their storage. Throws Error(device) where CUDA is not there, or cannot
/// share them: another GPU draws.
std::unique_ptr<GlBuffers> share_gl_buffers(std::span<const uint32_t> names);

}  // namespace meniscus::pbd
