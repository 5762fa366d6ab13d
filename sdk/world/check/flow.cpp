// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of definitions of emitters and sinks.
#include "sdk/world/check/check.h"

namespace meniscus::check {

namespace {

struct CheckRegion {
  void operator()(const BoxRegion& r) const { box("SinkDef::region", {r.lower, r.upper}); }
  void operator()(const BallRegion& r) const { positive("BallRegion::radius", r.radius); }
  void operator()(const HalfSpaceRegion& r) const {
    direction("HalfSpaceRegion::normal", r.normal);
    finite("HalfSpaceRegion::offset", r.offset);
  }
};

}  // namespace

void emitter(const EmitterDef& def) {
  pose("EmitterDef::pose", def.pose);
  positive("EmitterDef::speed", def.speed);
  not_negative("EmitterDef::rate", def.rate);
  not_negative("EmitterDef::start", def.start);
  if (!(def.stop >= def.start)) {
    refuse("EmitterDef::stop", std::to_string(def.stop),
           "at least EmitterDef::start, " + std::to_string(def.start));
  }
}

void sink(const SinkDef& def) {
  pose("SinkDef::pose", def.pose);
  std::visit(CheckRegion{}, def.region);
}

}  // namespace meniscus::check
