// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A row of small numbers for each thread of a block, in shared memory. Unlike registers, it can be indexed,
// and access is fast.
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

inline constexpr uint32_t cuda_block_size = 128;  ///< of launches with one item a thread

/// At most one in a kernel, as all use the same memory. Elements are written and read at addresses: that of
/// the first, and a fixed step between consecutive ones.
template <uint32_t most>
class OwnRow {
 public:
#ifdef __CUDA_ARCH__
  static constexpr uint32_t step = cuda_block_size * sizeof(uint16_t);

  __device__ OwnRow() {
    __shared__ uint16_t room[most * cuda_block_size];
    first_ = static_cast<uint32_t>(__cvta_generic_to_shared(room + threadIdx.x));
  }
  __device__ uint32_t first() const {
    return first_;
  }
  // The compiler does not recognise the address space of an address that a loop carries.
  __device__ void put(uint32_t place, uint32_t value) {
    asm volatile("st.shared.u16 [%0], %1;" ::"r"(place), "h"(static_cast<uint16_t>(value)));
  }
  __device__ uint32_t at(uint32_t place) const {
    uint16_t value;
    asm volatile("ld.shared.u16 %0, [%1];" : "=h"(value) : "r"(place));
    return value;
  }

 private:
  uint32_t first_;
#else
  static constexpr uint32_t step = 1;

  MENISCUS_HD static uint32_t first() {
    return 0;
  }
  MENISCUS_HD void put(uint32_t place, uint32_t value) {
    row_[place] = static_cast<uint16_t>(value);
  }
  MENISCUS_HD uint32_t at(uint32_t place) const {
    return row_[place];
  }

 private:
  uint16_t row_[most];
#endif
};

}  // namespace meniscus::pbd
