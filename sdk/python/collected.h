// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The garbage collector's view of a World of Python.
#pragma once

#include <nanobind/nanobind.h>

namespace meniscus::python {

/// For the class World: a function that a world calls may refer to the world.
PyType_Slot* world_slots();

}  // namespace meniscus::python
