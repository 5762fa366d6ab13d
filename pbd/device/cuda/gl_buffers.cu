// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// OpenGL buffers that CUDA kernels write.
#include "pbd/device/gl_buffers.h"

#include "pbd/device/cuda/cuda_device.cuh"

// As cuda_gl_interop.h declares it, which needs OpenGL's headers. The CUDA runtime exports it without OpenGL.
extern "C" cudaError_t CUDARTAPI cudaGraphicsGLRegisterBuffer(cudaGraphicsResource** resource,
                                                              unsigned buffer, unsigned flags);

namespace meniscus::pbd {

namespace {

class CudaGlBuffers final : public GlBuffers {
 public:
  explicit CudaGlBuffers(std::span<const uint32_t> names) {
    for (const uint32_t name : names) {
      cudaGraphicsResource* resource = nullptr;
      const cudaError_t status =
          cudaGraphicsGLRegisterBuffer(&resource, name, cudaGraphicsRegisterFlagsWriteDiscard);
      if (status != cudaSuccess) {
        cudaGetLastError();  // clears it: the device stays usable
        release();
        check_cuda(status, "sharing a buffer with OpenGL");
      }
      resources_.push_back(resource);
    }
  }
  ~CudaGlBuffers() override { release(); }

  std::vector<LentMemory> lend(Device& device) override {
    check_cuda(cudaGraphicsMapResources(count(), resources_.data(), stream_of(device)),
               "taking over buffers of OpenGL");
    std::vector<LentMemory> lent(resources_.size());
    for (size_t i = 0; i < lent.size(); ++i) {
      check_cuda(cudaGraphicsResourceGetMappedPointer(&lent[i].data, &lent[i].bytes, resources_[i]),
                 "taking over buffers of OpenGL");
    }
    return lent;
  }

  void give_back(Device& device) override {
    check_cuda(cudaGraphicsUnmapResources(count(), resources_.data(), stream_of(device)),
               "giving buffers back to OpenGL");
  }

 private:
  static cudaStream_t stream_of(Device& device) { return static_cast<CudaDevice&>(device).stream(); }
  int count() const { return static_cast<int>(resources_.size()); }
  void release() noexcept {
    for (cudaGraphicsResource* resource : resources_) cudaGraphicsUnregisterResource(resource);
  }

  std::vector<cudaGraphicsResource*> resources_;
};

}  // namespace

std::unique_ptr<GlBuffers> share_gl_buffers(std::span<const uint32_t> names) {
  return std::make_unique<CudaGlBuffers>(names);
}

}  // namespace meniscus::pbd
