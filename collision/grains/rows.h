// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays of the contacts among grains, one row a grain.
#pragma once

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

/// The contacts of grains with one another, one row a grain. Both grains of a contact have it in their rows.
/// Both compute the same result for it from the same numbers, bit by bit, except for the sign. So nothing is
/// scattered, and momentum is conserved.
///
/// Rows of `block` grains are interleaved, so that a warp's loads coalesce. The place of a row does not
/// depend on the number of grains that there is room for.
struct GrainRows {
  pbd::View<uint32_t> partner;
  pbd::View<pbd::Vec4> impulse;  ///< kg·m, on this grain in this substep; w: Coulomb's μ
  pbd::View<uint32_t> count;     ///< contacts of each grain
  uint32_t capacity = 0;         ///< contacts a row
  uint32_t block = 1;            ///< a power of two

  MENISCUS_HD size_t place(uint32_t i, uint32_t k) const {
    return (size_t{i / block} * capacity + k) * block + i % block;
  }
};

/// The number of elements that the rows of `grains` take.
inline size_t row_elements(uint32_t grains, uint32_t capacity, uint32_t block) {
  return size_t{(grains + block - 1) / block} * block * capacity;
}

}  // namespace meniscus::collision
