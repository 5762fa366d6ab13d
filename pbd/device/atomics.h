// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Atomics on integers alone: what they leave behind does not depend on the order, so they keep a run
// reproducible.
#pragma once

#include <cstdint>
#ifndef __CUDA_ARCH__
#include <atomic>
#endif

#include "pbd/device/qualifiers.h"

namespace meniscus::pbd {

MENISCUS_HD inline void atomic_max(uint32_t& target, uint32_t value) {
#ifdef __CUDA_ARCH__
  if (value > target) atomicMax(&target, value);  // seldom so: a plain look first
#else
  std::atomic_ref<uint32_t> shared(target);
  uint32_t seen = shared.load(std::memory_order_relaxed);
  while (seen < value && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
#endif
}

/// Returns what was there before, which does depend on the order.
MENISCUS_HD inline uint32_t atomic_add(uint32_t& target, uint32_t value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(&target, value);
#else
  return std::atomic_ref<uint32_t>(target).fetch_add(value, std::memory_order_relaxed);
#endif
}

}  // namespace meniscus::pbd
