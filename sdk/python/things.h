// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Classes of the things in a world, such as Body, and the calls of World that create and list them.
#pragma once

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Makes Fluid, Shape, Emitter, Sink, Probe, ForceField, Joint, Rope, Attachment.
void bind_things(nb::module_& module, nb::class_<PyWorld>& world);
void bind_body(nb::module_& module, nb::class_<PyWorld>& world);
void bind_cloth(nb::module_& module, nb::class_<PyWorld>& world);

/// Adds properties that set the pose, the filter and the surface of a shape.
void bind_surfaces(nb::class_<Handle<ShapeId>>& shape);
/// Adds properties that set the filter and the surface of a body.
void bind_surfaces(nb::class_<Handle<BodyId>>& body);
/// Adds properties that set the filter, of a granular material as well.
void bind_filter(nb::class_<Handle<FluidId>>& fluid);
/// Adds properties that set filters.
void bind_filters(nb::class_<Handle<ClothId>>& cloth, nb::class_<Handle<RopeId>>& rope);

}  // namespace meniscus::python
