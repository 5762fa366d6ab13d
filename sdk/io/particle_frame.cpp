// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Takes views of a world's particles, and checks the lengths of a frame's arrays.
#include "sdk/io/particle_frame.h"

namespace meniscus::io {
namespace {

void check_length(const char* name, std::size_t length, std::size_t wanted) {
  if (length == wanted) return;
  throw Error(ErrorCode::invalid_argument, std::string("frame.") + name + " has " + std::to_string(length) +
                                               " elements, but there are " + std::to_string(wanted) +
                                               " positions");
}

}  // namespace

ParticleFrame frame_of(const World& world) {
  return {.time = world.time(),
          .positions = world.positions(),
          .velocities = world.velocities(),
          .ids = world.ids(),
          .fluids = world.fluids(),
          .density_errors = world.density_errors(),
          .pressures = world.pressures()};
}

void check_lengths(const ParticleFrame& frame) {
  check_length("velocities", frame.velocities.size(), frame.size());
  check_length("ids", frame.ids.size(), frame.size());
  check_length("fluids", frame.fluids.size(), frame.size());
  check_length("density_errors", frame.density_errors.size(), frame.size());
  check_length("pressures", frame.pressures.size(), frame.size());
}

}  // namespace meniscus::io
