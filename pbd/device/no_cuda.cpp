// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces device/cuda/ in a build without CUDA.
#include <meniscus/error.h>

#include "pbd/device/choose.h"
#include "pbd/device/gl_buffers.h"
#include "pbd/device/stream_order.h"

namespace meniscus::pbd {

CudaStatus cuda_status(int) {
  return {.usable = false, .name = "", .reason = "built without CUDA", .memory_bytes = 0};
}

CudaScope::CudaScope(int ordinal) : ordinal_(ordinal) {}
CudaScope::~CudaScope() = default;

void put_after(void*, void*, int) {
  throw Error(ErrorCode::device, "streams cannot be ordered: built without CUDA");
}

std::unique_ptr<GlBuffers> share_gl_buffers(std::span<const uint32_t>) {
  throw Error(ErrorCode::device, "buffers of OpenGL cannot be shared: built without CUDA");
}

}  // namespace meniscus::pbd
