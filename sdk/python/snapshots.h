// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class Snapshot of Python, and the calls of World that take one and go back to it.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

void bind_snapshots(nb::module_& module, nb::class_<PyWorld>& world);

}  // namespace meniscus::python
