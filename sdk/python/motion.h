// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Motions of bodies from files.
#pragma once

#include <nanobind/nanobind.h>

namespace meniscus::python {

void bind_motion(nanobind::module_& module);

}  // namespace meniscus::python
