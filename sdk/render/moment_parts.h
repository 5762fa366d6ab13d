// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What of a moment is drawn.
#pragma once

#include "sdk/render/frame/moment.h"
#include "sdk/render/frame/stage.h"
#include "sdk/render/passes/needles.h"

namespace meniscus::render {

/// With the particles of its world as spans.
Moment with_spans(Moment moment);

/// Throws Error(invalid_argument) that names the array, where it has not one element an ellipsoid.
void check_count(const char* name, std::size_t count, std::size_t ellipsoids);

/// Adds all that is finite to the bounds of what stands still.
Bounds bounds_of(const Bounds& still, const Moment& moment);

/// Fluid as balls of one spacing's radius; grains are as they were.
std::vector<Ellipsoid> balls_at(const Moment& moment, const io::PreviewScene& scene);

/// One a triangle, where the view asks for them.
std::vector<Vec3> strain_colors(const io::ClothFrame& cloth, const ViewData& view);

/// From each contact along its normal, in a colour for each kind of thing that is touched.
std::vector<Needle> contact_needles(std::span<const ParticleContact> contacts, float length);

}  // namespace meniscus::render
