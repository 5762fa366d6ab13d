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

/// Tests of worlds that are alone and in batches, in five kinds of gravity.
class BatchRuns {
 protected:
  virtual ~BatchRuns() = default;
  virtual pbd::DeviceKind device() const = 0;
  virtual World archetype(const WorldDef& def) const = 0;

  WorldDef def() const { return batch_def(device()); }
  uint32_t many() const { return device() == pbd::DeviceKind::cuda ? 1024 : 64; }
  World of_kind(uint32_t kind) const {
    WorldDef own = def();
    own.gravity = gravity_of(kind);
    return archetype(own);
  }
  uint64_t alone(uint32_t kind, int steps) const {
    World world = of_kind(kind);
    run(world, steps, batch_dt);
    return world.state_hash();
  }
  /// World w is of kind `first` + w · `stride`.
  WorldBatch batch(uint32_t worlds, uint32_t first = 0, uint32_t stride = 1) const {
    WorldBatch made(archetype(def()), {worlds});
    std::vector<Vec3> gravities;
    for (uint32_t w = 0; w < worlds; ++w) gravities.push_back(gravity_of(first + stride * w));
    made.set_gravities(gravities);
    return made;
  }
  void expect_as_alone(uint32_t worlds, uint32_t first, uint32_t stride, int steps) const {
    WorldBatch made = batch(worlds, first, stride);
    run_batch(made, steps);
    uint64_t expected[5];
    for (uint32_t kind = 0; kind < 5; ++kind) expected[kind] = alone(kind, steps);
    for (uint32_t w = 0; w < worlds; ++w)
      EXPECT_EQ(made.state_hashes()[w], expected[(first + stride * w) % 5])
          << "world " << w << " of " << worlds;
  }
};

class BatchOnDevice : public OnDevice, protected BatchRuns {
 protected:
  pbd::DeviceKind device() const override { return GetParam(); }
};

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
