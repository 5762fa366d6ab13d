// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What tests of batches share.
#pragma once

#include <string>

#include "tests/worlds.h"

namespace meniscus::tests {

inline constexpr float batch_dt = 0.01f;

inline WorldDef batch_def(pbd::DeviceKind device) {
  WorldDef def = world_def(device, 0.1f);
  def.sums = Sums::fixed;
  def.iterations = 3;
  return def;
}

/// One of five kinds of world.
inline Vec3 gravity_of(uint32_t kind) {
  return {0.8f * static_cast<float>(kind % 5) - 1.2f, -9.81f, 0.5f * static_cast<float>(kind % 5)};
}

inline void run_batch(WorldBatch& batch, int steps) {
  for (int k = 0; k < steps; ++k) batch.step(batch_dt);
}

/// A mask of so many worlds with these in it.
inline std::vector<uint8_t> mask_of(uint32_t worlds, std::initializer_list<uint32_t> chosen) {
  std::vector<uint8_t> mask(worlds, 0);
  for (const uint32_t w : chosen) mask[w] = 1;
  return mask;
}

/// The message with which a call is refused.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace meniscus::tests
