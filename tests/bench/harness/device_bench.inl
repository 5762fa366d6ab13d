// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The harness of the parallel algorithms, for one device.
#pragma once

#include <numeric>

#include "pbd/device/base/atomics.h"
#include "pbd/device/buffer.h"
#include "tests/bench/harness/device_bench.h"

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

struct Double {
  struct Pair {
    float a, b;
  };
  static constexpr uint32_t count = 16;
  Pair pairs[count];
  bool doubles;
  float number;
  pbd::View<float> out;

  MENISCUS_HD void operator()(uint32_t i) const {
    out[i] = i < count ? (doubles ? 2.0f : 1.0f) * (pairs[i].a + pairs[i].b) : number;
  }
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

  std::vector<uint32_t> rounds(uint32_t count, uint32_t launches, uint32_t rounds, uint32_t period) override {
    for (pbd::Buffer<uint32_t>* b : {&visits_, &beside_, &copied_, &sums_}) {
      if (b->size() < count + 1) b->resize_discard(count + 1);
    }
    const pbd::View<uint32_t> visits = visits_.view().first(count), beside = beside_.view().first(count),
                              copied = copied_.view().first(count), sums = sums_.view().first(count + 1);
    const auto visit = [&](pbd::View<uint32_t> what) {
      device_.parallel_for("test", what.count, bench_kernels::CountVisit{what});
    };
    std::vector<uint32_t> found;
    for (uint32_t round = 0; round < rounds; ++round) {
      device_.fill(visits.data, 0, count * sizeof(uint32_t));
      device_.fill(beside.data, 0, count * sizeof(uint32_t));
      for (uint32_t k = 0; k < launches; ++k) {
        device_.at_once([&] { visit(visits); }, [&] { visit(beside); });
      }
      visit(visits.first(count - round % period));
      device_.copy(copied.data, visits.data, count * sizeof(uint32_t));
      device_.exclusive_scan("test", copied, sums);
      uint32_t all = 0, one = 0;
      device_.copy_out(&all, sums.data + count, sizeof all);
      device_.copy_out(&one, beside.data, sizeof one);
      found.push_back(all + one);
    }
    return found;
  }

  std::vector<float> doubled(const std::array<float, 32>& pairs, float number) override {
    using bench_kernels::Double;
    pbd::Buffer<float> sums(device_, "test");
    sums.resize_discard(Double::count + 1);
    Double kernel{{}, true, number, sums.view()};
    for (size_t k = 0; k < Double::count; ++k) kernel.pairs[k] = {pairs[2 * k], pairs[2 * k + 1]};
    device_.parallel_for("test", Double::count + 1, kernel);
    return sums.read(Double::count + 1);
  }

  uint64_t graphs_sent() const override {
    if constexpr (requires { device_.graphs_sent(); }) return device_.graphs_sent();
    return 0;
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
  pbd::Buffer<uint32_t> visits_{device_, "visits"}, beside_{device_, "visits beside"},
      copied_{device_, "copied visits"}, sums_{device_, "summed visits"};
};

}  // namespace meniscus::tests
