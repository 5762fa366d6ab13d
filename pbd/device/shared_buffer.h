// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// An owned array in host memory that kernels can access.
#pragma once

#include <span>
#include <type_traits>

#include "pbd/device/base/view.h"
#include "pbd/device/device.h"

namespace meniscus::pbd {

/// Owns an array in host memory that kernels read and write as well, for small data that are exchanged often.
/// The host may access it when the launches that use it are done (Device::wait, Device::wait_for_fence).
template <class T>
class SharedBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  SharedBuffer(Device& device, const char* what) : device_(device), what_(what) {}
  ~SharedBuffer() { free_memory(); }
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  /// Sets a new length; the contents are lost.
  void resize_discard(uint32_t size) {
    if (size == size_) return;
    free_memory();
    if (size) data_ = static_cast<T*>(device_.allocate_shared(size * sizeof(T), what_));
    size_ = size;
  }

  View<T> view() const { return {data_, size_}; }
  std::span<T> host() const { return {data_, size_}; }

 private:
  void free_memory() noexcept {
    device_.release_shared(data_, size_ * sizeof(T));
    data_ = nullptr;
    size_ = 0;
  }

  Device& device_;
  const char* what_;
  T* data_ = nullptr;
  uint32_t size_ = 0;
};

}  // namespace meniscus::pbd
