// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Choices and numbers from the bytes of a fuzzer's input, and files with given contents.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>

#include <meniscus/types.h>

namespace meniscus::fuzz {

/// Reads an input from its beginning. Behind its end there are zeros.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data, size) {}

  bool at_end() const { return data_.empty(); }
  std::span<const std::uint8_t> rest() const { return data_; }

  std::uint8_t byte() {
    if (data_.empty()) return 0;
    const std::uint8_t first = data_.front();
    data_ = data_.subspan(1);
    return first;
  }
  std::uint32_t below(std::uint32_t n) { return byte() % n; }
  bool flag() { return (byte() & 1) != 0; }

  /// Mostly a number between both in 200 steps, and otherwise one that a user might get wrong.
  float number(float low, float high) {
    constexpr float odd[] = {0.0f,
                             -1.0f,
                             1e-30f,
                             1e30f,
                             std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN(),
                             -1e-30f,
                             1e6f};
    const std::uint8_t b = byte();
    if (b >= 248) return odd[b - 248];
    return low + (high - low) * static_cast<float>(b % 200) / 199;
  }
  Vec3 vector(float low, float high) {
    const float x = number(low, high), y = number(low, high), z = number(low, high);
    return {x, y, z};
  }

 private:
  std::span<const std::uint8_t> data_;
};

/// A file in memory, with a path, until it is destroyed.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes) : number_(memfd_create("input", 0)) {
    if (number_ < 0 || write(number_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
  ~MemoryFile() { close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

}  // namespace meniscus::fuzz
