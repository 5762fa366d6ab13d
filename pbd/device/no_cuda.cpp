// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces device/cuda/ in a build without CUDA.
#include <meniscus/error.h>

#include "pbd/device/choose.h"
#include "pbd/device/gl_buffers.h"

namespace meniscus::pbd {

CudaStatus cuda_status() {
  return {.usable = false, .name = "", .reason = "built without CUDA", .memory_bytes = 0};
}

std::unique_ptr<GlBuffers> share_gl_buffers(std::span<const uint32_t>) {
  throw Error(ErrorCode::device, "buffers of OpenGL cannot be shared: built without CUDA");
}

}  // namespace meniscus::pbd
