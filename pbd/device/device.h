// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A device as the host sees it: memory, copies and time marks. The parallel algorithms (parallel_for, sort,
// scan, reduce) are members of CpuDevice and CudaDevice; the host code is a template over these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "pbd/device/call_monitor.h"

namespace meniscus::pbd {

enum class DeviceKind { cpu, cuda };

class Device {
 public:
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  virtual DeviceKind kind() const = 0;
  virtual std::string name() const = 0;

  /// Uninitialised memory, aligned to 64 bytes. Throws Error(out_of_memory), naming `what`.
  void* allocate(size_t bytes, const char* what);
  void release(void* memory, size_t bytes, const char* what) noexcept;
  const MemoryUse& memory() const { return memory_; }
  const MemoryUse& shared_memory() const { return shared_memory_; }  ///< of allocate_shared
  /// Of the call that runs. One thread at a time makes calls.
  CallMonitor& monitor() { return monitor_; }
  /// Whether a sum over neighbours runs in the same order for any number of items, as the CPU's always do. A
  /// GPU otherwise lets several threads share one item's sum where items are few.
  bool fixes_sums() const { return fixes_sums_; }
  void fix_sums(bool fixed) { fixes_sums_ = fixed; }
  /// Bytes held now, by purpose.
  const std::map<std::string, size_t, std::less<>>& held() const { return held_; }

  /// Host memory that kernels can use as well. Throws Error(out_of_memory), naming `what`.
  void* allocate_shared(size_t bytes, const char* what);
  void release_shared(void* memory, size_t bytes) noexcept;

  /// Copies are ordered with the kernels launched before and after. Only copy_out waits for the result.
  virtual void copy_in(void* device_memory, const void* host, size_t bytes) = 0;
  virtual void copy_out(void* host, const void* device_memory, size_t bytes) = 0;
  virtual void copy(void* to, const void* from, size_t bytes) = 0;
  virtual void fill(void* memory, unsigned char byte, size_t bytes) = 0;
  virtual void wait() = 0;
  /// Sends all launches so far, because the host turns to other work.
  virtual void send_off() {}
  /// Marks a place in the device's work; wait_for_fence() returns when all work before it is done.
  virtual void set_fence() = 0;
  virtual void wait_for_fence() = 0;

  /// Marks the present place in the device's work as number `mark`; elapsed_ms may be called after wait().
  virtual void mark_time(uint32_t mark) = 0;
  virtual double elapsed_ms(uint32_t from, uint32_t to) const = 0;

 protected:
  Device() = default;

 private:
  [[noreturn]] void refuse(size_t bytes, const char* what) const;
  virtual void* do_allocate(size_t bytes) = 0;  // nullptr when there is none left
  virtual void do_release(void* memory) noexcept = 0;
  virtual void* do_allocate_shared(size_t bytes) = 0;
  virtual void do_release_shared(void* memory) noexcept = 0;

  CallMonitor monitor_;
  bool fixes_sums_ = false;
  MemoryUse memory_, shared_memory_;
  std::map<std::string, size_t, std::less<>> held_;
};

}  // namespace meniscus::pbd
