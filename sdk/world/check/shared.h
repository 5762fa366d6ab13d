// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which calls of World a shared world allows.
#pragma once

#include <cstdint>
#include <string_view>

namespace meniscus::check {

/// Throws Error(invalid_argument) if a world that `ranks` ranks share does not allow this call of World.
void allowed_when_shared(std::string_view call, uint32_t ranks);

/// Whether a call does without particles on the device, while a world is built that ranks are to share.
bool needs_no_particles(std::string_view call);

}  // namespace meniscus::check
