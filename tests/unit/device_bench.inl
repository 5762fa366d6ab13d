// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>

#include "pbd/device/atomics.h"
#include "pbd/device/buffer.h"
#include "tests/unit/device_bench.h"

namespace meniscus::tests {

namespace bench_kernels {

struct ReadFloat {
  pbd::View<const float> from;

  MENISCUS_HD float operator()(uint32_t i) const { return from[i]; }
};

struct AddFloats {
  MENISCUS_HD float operator()(float a, float b) const { return a + b; }
};

struct CountVisit {
  pbd::View<uint32_t> visits;

  MENISCUS_HD void operator()(uint32_t i) const { pbd::atomic_add(visits[i], 1); }
};

}  // namespace bench_kernels

template <class D>
class DeviceBenchOn final : public DeviceBench {
 public:
  template <class... Args>
  explicit DeviceBenchOn(Args... device_arguments) : device_(device_arguments...) {}

  pbd::Device& device() override { return device_; }

  SortedPairs sort(std::span<const uint32_t> keys, uint32_t bits) override {
    const auto count = static_cast<uint32_t>(keys.size());
    std::vector<uint32_t> places(count);
    std::iota(places.begin(), places.end(), 0u);
    pbd::Buffer<uint32_t> in = filled<uint32_t>(keys), numbers = filled<uint32_t>(places);
    pbd::Buffer<uint32_t> sorted_keys(device_, "sorted keys"), sorted_places(device_, "sorted places");
    sorted_keys.resize_discard(count);
    sorted_places.resize_discard(count);
    device_.sort_pairs("test", in.view(), sorted_keys.view(), numbers.view(), sorted_places.view(), bits);
    return {sorted_keys.read(count), sorted_places.read(count)};
  }

  std::vector<uint32_t> scan(std::span<const uint32_t> values, uint32_t limit, pbd::SumNote* note) override {
    pbd::Buffer<uint32_t> in = filled(values), out(device_, "scanned");
    out.resize_discard(in.size() + 1);
    pbd::Buffer<pbd::SumNote> notes = filled(std::span<const pbd::SumNote>(note, note ? 1 : 0));
    device_.exclusive_scan("test", in.view(), out.view(), limit, notes.view());
    if (note) *note = notes.read(1)[0];
    return out.read(out.size());
  }

  float sum(std::span<const float> values) override {
    pbd::Buffer<float> in = filled(values), out(device_, "sum");
    out.resize_discard(1);
    device_.reduce("test", in.size(), 0.0f, bench_kernels::ReadFloat{in.view()}, bench_kernels::AddFloats{},
                   out.view());
    return out.read(1)[0];
  }

  std::vector<uint32_t> visits(uint32_t count) override {
    pbd::Buffer<uint32_t> buffer(device_, "visits");
    buffer.resize_discard(count + 1);
    buffer.fill(0);
    device_.parallel_for("test", count, bench_kernels::CountVisit{buffer.view()});
    return buffer.read(count + 1);
  }

  std::vector<uint32_t> resized(uint32_t from, uint32_t size, uint32_t kept) override {
    std::vector<uint32_t> values(from);
    std::iota(values.begin(), values.end(), 0u);
    pbd::Buffer<uint32_t> buffer = filled<uint32_t>(values);
    buffer.resize_keep(size, kept);
    return buffer.read(kept);
  }

 private:
  template <class T>
  pbd::Buffer<T> filled(std::span<const T> values) {
    pbd::Buffer<T> buffer(device_, "test input");
    buffer.resize_discard(static_cast<uint32_t>(values.size()));
    buffer.write(values);
    return buffer;
  }

  D device_;
};

}  // namespace meniscus::tests
