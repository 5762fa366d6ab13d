// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

/// The contacts of grains with one another, a row a grain. Both grains of a contact have it in their rows,
/// and find the same for it from the same numbers, bit by bit, but for the sign: so nothing is scattered, and
/// momentum is kept.
///
/// Rows of `block` grains lie interleaved, so that a warp's loads coalesce; where a row is, does not depend
/// on how many grains there is room for.
struct GrainRows {
  pbd::View<uint32_t> partner;
  pbd::View<pbd::Vec4> impulse;  ///< kg·m, on this grain in this substep; w: Coulomb's μ
  pbd::View<uint32_t> count;     ///< of each grain
  uint32_t capacity = 0;         ///< contacts a row
  uint32_t block = 1;            ///< a power of two

  MENISCUS_HD size_t place(uint32_t i, uint32_t k) const {
    return (size_t{i / block} * capacity + k) * block + i % block;
  }
};

/// Elements that rows of `grains` take.
inline size_t row_elements(uint32_t grains, uint32_t capacity, uint32_t block) {
  return size_t{(grains + block - 1) / block} * block * capacity;
}

}  // namespace meniscus::collision
