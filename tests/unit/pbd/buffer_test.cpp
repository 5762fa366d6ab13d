// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of buffers in device memory.
#include "pbd/device/buffer.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <array>
#include <numeric>

#include "tests/bench/harness/device_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {
namespace {

using pbd::Buffer;

class BufferTest : public OnDevice {
 protected:
  std::unique_ptr<DeviceBench> bench_ = make_device_bench(GetParam());
  pbd::Device& device_ = bench_->device();
};

TEST_P(BufferTest, WhatIsWrittenIsRead) {
  Buffer<int> buffer(device_, "numbers");
  buffer.resize_discard(5);
  buffer.write(std::vector<int>{1, 2, 3, 4, 5});
  buffer.write(std::vector<int>{30, 40}, 2);
  EXPECT_EQ(buffer.read(5), (std::vector<int>{1, 2, 30, 40, 5}));
  std::vector<int> last(2);
  buffer.read(std::span(last), 3);
  EXPECT_EQ(last, (std::vector<int>{40, 5}));
}

TEST_P(BufferTest, ResizeKeepKeepsTheFirst) {
  for (const auto& [from, to, kept] :
       {std::array{5u, 100000u, 5u}, {100000u, 7u, 7u}, {8u, 8u, 8u}, {8u, 9u, 3u}}) {
    std::vector<uint32_t> expected(kept);
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(bench_->resized(from, to, kept), expected) << from << " to " << to;
  }
}

TEST_P(BufferTest, FillSetsEveryByte) {
  Buffer<uint32_t> buffer(device_, "numbers");
  buffer.resize_discard(1000);
  buffer.fill(0xab);
  EXPECT_EQ(buffer.read(1000), std::vector<uint32_t>(1000, 0xabababab));
}

TEST_P(BufferTest, TheDeviceCountsWhatItHolds) {
  const MemoryUse before = device_.memory();
  {
    Buffer<double> a(device_, "a"), b(device_, "b");
    a.resize_discard(1000);
    b.resize_discard(10);
    EXPECT_EQ(device_.memory().bytes, before.bytes + 8080);
    a.resize_discard(1000);
    EXPECT_EQ(device_.memory().allocations, before.allocations + 2);
    Buffer<double> c = std::move(a);
    EXPECT_EQ(device_.memory().bytes, before.bytes + 8080);
    c.resize_discard(0);
    EXPECT_EQ(device_.memory().bytes, before.bytes + 80);
  }
  EXPECT_EQ(device_.memory().bytes, before.bytes);
  EXPECT_EQ(device_.memory().peak_bytes, std::max(before.peak_bytes, before.bytes + 8080));
}

TEST_P(BufferTest, TheDeviceKnowsWhatItHoldsItFor) {
  const auto held = [&](const char* what) {
    const auto found = device_.held().find(what);
    return found == device_.held().end() ? 0 : found->second;
  };
  Buffer<double> a(device_, "numbers"), b(device_, "numbers"), c(device_, "others");
  a.resize_discard(100);
  b.resize_discard(10);
  c.resize_discard(1);
  EXPECT_EQ(held("numbers"), 880u);
  EXPECT_EQ(held("others"), 8u);
  a.swap(c);
  c.resize_discard(0);
  EXPECT_EQ(held("numbers"), 80u);
  EXPECT_EQ(held("others"), 8u);
  a.resize_keep(2, 1);
  EXPECT_EQ(held("others"), 16u);
}

TEST_P(BufferTest, MemoryIsAlignedToACacheLine) {
  Buffer<char> a(device_, "a"), b(device_, "b");
  a.resize_discard(1);
  b.resize_discard(1);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(a.view().data) % 64, 0u);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(b.view().data) % 64, 0u);
}

TEST_P(BufferTest, TooMuchIsAnErrorThatNamesTheArray) {
  struct Megabyte {
    char bytes[1 << 20];
  };
  const size_t held = device_.memory().bytes;
  Buffer<Megabyte> buffer(device_, "the absurd array");
  try {
    buffer.resize_discard(0xffffffff);  // four petabytes
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::out_of_memory);
    EXPECT_NE(std::string(error.what()).find("the absurd array"), std::string::npos) << error.what();
  }
  EXPECT_EQ(device_.held().at("the absurd array"), 0u);
  EXPECT_EQ(buffer.size(), 0u);
  EXPECT_EQ(device_.memory().bytes, held);
  Buffer<int> after(device_, "an ordinary array");
  after.resize_discard(3);
  after.write(std::vector<int>{1, 2, 3});
  EXPECT_EQ(after.read(3), (std::vector<int>{1, 2, 3}));
}

TEST_P(BufferTest, AFailedResizeKeepLeavesTheOldValues) {
  struct Megabyte {
    char bytes[1 << 20];
  };
  Buffer<Megabyte> buffer(device_, "numbers");
  buffer.resize_discard(1);
  buffer.fill(3);
  EXPECT_THROW(buffer.resize_keep(0xffffffff, 1), Error);
  EXPECT_EQ(buffer.size(), 1u);
  EXPECT_EQ(buffer.read(1)[0].bytes[77], 3);
}

MENISCUS_ON_EACH_DEVICE(BufferTest);

}  // namespace
}  // namespace meniscus::tests
