// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The emitters and sinks of a World.
#pragma once

#include <meniscus/flow.h>

#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/flow/duct.h"
#include "sdk/world/flow/emitter_clock.h"
#include "sdk/world/flow/emitter_sites.h"

namespace meniscus {

struct EmitterEntry {
  EmitterDef def;
  EmitterSites sites;
  EmitterClock clock;
  FlowCount count;
  std::vector<Departure> departures;  // of the present step
  Pose body_before;                   // at the start of the step
  Duct duct;                          // if it is imposed
};

struct SinkEntry {
  SinkDef def;
  FlowCount count;
};

/// What the emitters of a world make in a step. It is kept so that its memory is reused.
struct Emission {
  std::vector<Arrival> arrivals;
  std::vector<uint8_t> has_room;
  ParticleBatch batch;
};

}  // namespace meniscus
