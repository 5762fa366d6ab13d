// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The input is a motion file: a byte chooses its format, and another the prim. A body that follows what is
// read makes two steps. Only Error may be thrown.
#include <meniscus/meniscus.h>

#include <optional>

#include "tests/fuzz/bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meniscus;
  fuzz::Bytes bytes(data, size);
  MotionFile motion{.file = bytes.flag() ? "motion.usda" : "motion.csv"};
  if (bytes.flag()) motion.prim = "/World/Arm";
  const std::string text(bytes.rest().begin(), bytes.rest().end());
  try {
    BodyDef body{.motion = BodyMotion::kinematic};
    body.keyframes = read_keyframes(motion, [&](const std::string&) { return std::optional(text); });
    World world(WorldDef{.device = DeviceChoice::cpu, .threads = 1});
    world.create_body(body);
    for (int k = 0; k < 2; ++k) world.step(0.01f);
  } catch (const Error&) {
  }
  return 0;
}
