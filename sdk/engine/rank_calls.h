// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What rank 0 of a shared world asks the others to do along with it.
#pragma once

#include <cstdint>

namespace meniscus {

enum class RankCall : uint32_t {
  end,    ///< nothing more
  pause,  ///< nothing until they follow again
  step,
  positions,
  velocities,
  fluids,
  pressures,
  density_errors,
  ellipsoids,
  diffuse,
  hash,
  diagnostics,
  counts,
  probes,
  set_sinks,
  take_sinks,
  find_room,
  append,
  keep,
  set_pistons,
  save
};

struct RankCommand {
  RankCall call;
  int32_t iterations = 0;  ///< of a step; of a file the length of its path; of a list its length
  float dt = 0;            ///< s, of a step or its substeps
};

}  // namespace meniscus
