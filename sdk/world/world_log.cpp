// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a world says to its log.
#include <sstream>

#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

struct Excess {
  uint32_t count;
  const char* matter;
  const char* text;  ///< after the count
};

}  // namespace

/// What World::warnings() finds, before the first step.
void World::Impl::log_before_steps() {
  if (!log.is_read()) return;
  for (const std::string& warning : Calls{this}.warnings()) log.warn_once(warning.c_str(), warning);
}

/// What a step left out, each kind once.
void World::Impl::log_step(const StepReport& report) {
  if (!log.is_read()) return;
  const Overflows& o = report.overflows;
  const Excess kinds[] = {
      {o.cloth_layers, "cloth_layers",
       " particles are near more than three layers of cloth, and touch three"},
      {o.cloth_vertices, "cloth_vertices",
       " contacts of particles have more than 32 vertices of cloth in reach; finer particles have fewer"},
      {o.fluid_failsafe, "fluid_failsafe",
       " particles may have passed through cloth; more substeps keep them back"},
      {o.cloth_failsafe, "cloth_failsafe",
       " substeps did not keep cloth apart, and all cloth stayed where it was; more substeps help"},
      {o.emitter_hold, "emitter_hold", " particles from emitters keep their velocity for 255 steps"},
      {report.diffuse_refused, "diffuse_refused",
       " diffuse particles were not made; DiffuseDef::capacity holds no more"}};
  for (const Excess& kind : kinds) {
    if (kind.count)
      log.warn_once(kind.matter,
                    "at " + std::to_string(time) + " s " + std::to_string(kind.count) + kind.text);
  }
  if (report.emission_refused <= 0) return;
  std::ostringstream text;
  text << "at " << time << " s emitters found no room for " << report.emission_refused << " m³";
  log.warn_once("emission_refused", text.str());
}

}  // namespace meniscus
