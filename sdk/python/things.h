// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Classes of the things in a world, such as Body, and the calls of World that create and list them.
#pragma once

#include "sdk/python/handle.h"

namespace meniscus::python {

/// Makes Fluid, Shape, Emitter, Sink, Probe, ForceField, Joint, Rope, Attachment.
void bind_things(nb::module_& module, nb::class_<PyWorld>& world);
void bind_body(nb::module_& module, nb::class_<PyWorld>& world);
void bind_cloth(nb::module_& module, nb::class_<PyWorld>& world);

}  // namespace meniscus::python
