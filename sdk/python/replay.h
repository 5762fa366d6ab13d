// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The class Replay of Python.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

void bind_replay(nb::module_& module);

}  // namespace meniscus::python
