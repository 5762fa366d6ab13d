// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Definitions in Python: classes for their parts, and properties of what has members that can change.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Makes a class of each struct that a definition is made of.
void bind_definitions(nb::module_& module);

/// Adds a property for each member of WorldDef.
void bind_world_members(nb::class_<PyWorld>& type);
/// Adds a property for each member of ForceFieldDef.
void bind_force_field_members(nb::class_<Handle<ForceFieldId>>& type);
/// Adds a property for each member of FluidDef.
void bind_fluid_members(nb::class_<Handle<FluidId>>& type);

}  // namespace meniscus::python
