// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class World of Python.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Adds construction, steps and measurements.
void bind_world(nb::class_<PyWorld>& world);
/// Adds load_scene() to the module, and pictures to World.
void bind_scenes(nb::module_& module, nb::class_<PyWorld>& world);

}  // namespace meniscus::python
