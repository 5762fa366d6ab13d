// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Buffers that OpenGL and CUDA share.
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

/// OpenGL buffers in memory that CUDA kernels use as well. Create, lend and destroy them with OpenGL's
/// context current.
class GlBuffers {
 public:
  virtual ~GlBuffers() = default;

  /// Lends the memory to later launches on this CUDA device, after all earlier OpenGL commands.
  virtual std::vector<LentMemory> lend(Device& device) = 0;
  /// Later OpenGL commands follow the launches so far.
  virtual void give_back(Device& device) = 0;
};

/// By the names of the buffers, which must keep their storage. Throws Error(device) where CUDA is missing, or
/// cannot share them because another GPU draws.
std::unique_ptr<GlBuffers> share_gl_buffers(std::span<const uint32_t> names);

}  // namespace meniscus::pbd
