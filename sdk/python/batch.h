// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class WorldBatch of Python.
#pragma once

#include <meniscus/batch.h>

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Makes the class WorldBatch.
void bind_batch(nb::module_& module);

}  // namespace meniscus::python
