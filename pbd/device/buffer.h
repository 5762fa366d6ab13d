// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// An owned array in a device's memory.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/device/device.h"

namespace meniscus::pbd {

/// Owns an array in a device's memory. Its length is set explicitly and never changes within a warm step.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// `what` names the array in errors and memory budgets; it must outlive the buffer.
  Buffer(Device& device, const char* what) : device_(&device), what_(what) {}
  ~Buffer() { free_memory(); }

  Buffer(Buffer&& other) noexcept
      : device_(other.device_),
        what_(other.what_),
        data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  void swap(Buffer& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(what_, other.what_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

  size_t size() const { return size_; }
  /// A view counts up to 2³² − 1 elements. Larger arrays are accessed by the pointer.
  View<T> view() { return {data_, viewed()}; }
  View<const T> view() const { return {data_, viewed()}; }

  /// Sets a new length; the contents are lost.
  void resize_discard(size_t size) {
    if (size == size_) return;
    free_memory();
    if (size) data_ = static_cast<T*>(device_->allocate(bytes(size), what_));
    size_ = size;
  }

  /// The same, but the length is unchanged if there is not enough memory.
  void resize_or_stay(size_t size) {
    const size_t before = size_;
    try {
      resize_discard(size);
    } catch (...) {
      resize_discard(before);
      throw;
    }
  }

  /// Sets a new length; the first `kept` elements are kept.
  void resize_keep(size_t size, size_t kept) {
    if (size == size_) return;
    Buffer next(*device_, what_);
    next.resize_discard(size);
    if (kept) device_->copy(next.data_, data_, bytes(kept));
    device_->wait();
    swap(next);
  }

  void fill(unsigned char byte) {
    if (size_) device_->fill(data_, byte, bytes(size_));
  }
  void write(std::span<const T> host, uint32_t at = 0) {
    if (!host.empty()) device_->copy_in(data_ + at, host.data(), host.size_bytes());
  }
  void read(std::span<T> host, uint32_t at = 0) const {
    if (!host.empty()) device_->copy_out(host.data(), data_ + at, host.size_bytes());
  }
  std::vector<T> read(size_t count) const {
    std::vector<T> host(count);
    read(std::span<T>(host));
    return host;
  }

 private:
  static size_t bytes(size_t count) { return count * sizeof(T); }
  uint32_t viewed() const { return static_cast<uint32_t>(size_ < 0xffffffff ? size_ : 0xffffffff); }
  void free_memory() noexcept {
    if (data_) device_->release(data_, bytes(size_), what_);
    data_ = nullptr;
    size_ = 0;
  }

  Device* device_;
  const char* what_;
  T* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace meniscus::pbd
