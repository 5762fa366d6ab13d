// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in files.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Adds save(), load(), clone(), start_recording() and stop_recording().
void bind_world_files(nb::class_<PyWorld>& world);

}  // namespace meniscus::python
