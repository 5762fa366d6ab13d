// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the draft of a floating box must be.
#pragma once

#include <cmath>

#include "sdk/validation/cases/floating_box.h"
#include "tests/validation/measures.h"
#include "tests/worlds.h"

namespace meniscus::tests {

/// In the last of ten seconds the box's mean draft must be what Archimedes says, within 3 % of the box's
/// height; at the end it is at rest (1 cm/s) and level (1°).
inline void expect_draft(pbd::DeviceKind device, const validation::DraftCase& draft) {
  const WorldDef def = world_def(device, draft.spacing);
  record_device(World(def));
  const validation::DraftMeasure measure = validation::measure_draft(def, draft);
  record("surface_offset_spacings", measure.surface_offset);
  record("draft_error_percent", 100 * std::fabs(measure.error));
  record("tilt_degrees", measure.tilt);
  record("speed", measure.speed);
  EXPECT_LT(std::fabs(measure.error), 0.03);
  EXPECT_LT(measure.tilt, 1);
  EXPECT_LT(measure.speed, 0.01);
  EXPECT_EQ(measure.outside, 0u);
}

}  // namespace meniscus::tests
