// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The calls that a shared world allows: steps, what needs no particles, and read-outs by rank 0.
#include "sdk/world/check/shared.h"

#include <meniscus/error.h>

#include <algorithm>
#include <array>
#include <string>

namespace meniscus::check {

void allowed_when_shared(std::string_view call, uint32_t ranks) {
  using namespace std::literals;
  static constexpr std::array allowed{"follow"sv,
                                      "step"sv,
                                      "run_end_of_step"sv,
                                      "step_begin"sv,
                                      "time"sv,
                                      "def"sv,
                                      "device"sv,
                                      "support_radius"sv,
                                      "particle_mass"sv,
                                      "fluid_ids"sv,
                                      "shape_ids"sv,
                                      "body_ids"sv,
                                      "joint_ids"sv,
                                      "cloth_ids"sv,
                                      "rope_ids"sv,
                                      "emitter_ids"sv,
                                      "sink_ids"sv,
                                      "probe_ids"sv,
                                      "attachment_ids"sv,
                                      "particle_count"sv,
                                      "ids"sv,
                                      "positions"sv,
                                      "velocities"sv,
                                      "fluids"sv,
                                      "density_errors"sv,
                                      "pressures"sv,
                                      "ellipsoids"sv,
                                      "diffuse"sv,
                                      "diagnostics"sv,
                                      "state_hash"sv,
                                      "device_bytes"sv,
                                      "memory_shares"sv,
                                      "memory_stats"sv,
                                      "body_mass"sv,
                                      "body_state"sv,
                                      "hinge_angle"sv,
                                      "contact_events"sv,
                                      "solid_contacts"sv,
                                      "emitter_count"sv,
                                      "emitter_pressure"sv,
                                      "sink_count"sv,
                                      "probe"sv,
                                      "probe_vector"sv,
                                      "tear_events"sv,
                                      "flow_events"sv,
                                      "sleep_events"sv,
                                      "mesh_repairs"sv,
                                      "warnings"sv,
                                      "save"sv};
  if (std::find(allowed.begin(), allowed.end(), call) != allowed.end()) return;
  throw Error(ErrorCode::invalid_argument, std::string(call) + " was called for a world that " +
                                               std::to_string(ranks) +
                                               " ranks share, which allows steps, read-outs and save");
}

bool needs_no_particles(std::string_view call) {
  using namespace std::literals;
  static constexpr std::array calls{
      "SharedWorld"sv,  "create_fluid"sv, "create_shape"sv, "create_body"sv,    "create_joint"sv,
      "create_sink"sv,  "create_probe"sv, "add_fluid"sv,    "create_emitter"sv, "particle_count"sv,
      "ids"sv,          "fluid_ids"sv,    "shape_ids"sv,    "body_ids"sv,       "def"sv,
      "device_bytes"sv, "device"sv,       "memory_stats"sv};
  return std::find(calls.begin(), calls.end(), call) != calls.end();
}

}  // namespace meniscus::check
