// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of a moment that are drawn.
#pragma once

#include "sdk/render/frame/moment.h"
#include "sdk/render/frame/stage.h"
#include "sdk/render/passes/needles.h"

namespace meniscus::render {

/// Returns the moment with the particles of its world as spans.
Moment with_spans(Moment moment);

/// Throws Error(invalid_argument) that names the array, unless it has one element per ellipsoid.
void check_count(const char* name, std::size_t count, std::size_t ellipsoids);

/// Adds everything finite to the bounds of the static objects.
Bounds bounds_of(const Bounds& still, const Moment& moment);

/// Fluid as balls with a radius of one spacing; grains are unchanged.
std::vector<Ellipsoid> balls_at(const Moment& moment, const io::PreviewScene& scene);

/// One colour per triangle, if the view asks for them.
std::vector<Vec3> strain_colors(const io::ClothFrame& cloth, const ViewData& view);

/// Lines from each contact along its normal, in a colour per kind of touched object.
std::vector<Needle> contact_needles(std::span<const ParticleContact> contacts, float length);

}  // namespace meniscus::render
