// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Images of fixed shapes and of points across the seams of periodic axes.
#pragma once

#include <meniscus/types.h>

#include <span>
#include <string>
#include <vector>

#include "collision/contact/shape.h"
#include "pbd/math/periodic_axes.h"

namespace meniscus {

/// A fixed shape, and its images that come within `reach` (m) of where particles are. Throws
/// Error(invalid_argument), which names the shape, if space with it does not repeat itself.
std::vector<collision::Shape> with_seam_images(const collision::Shape& shape, const pbd::PeriodicAxes& axes,
                                               float reach, const std::string& name);

/// These points, and their images within `reach` (m) of where particles are.
std::vector<Vec3> with_seam_images(std::span<const Vec3> points, const pbd::PeriodicAxes& axes, float reach);

}  // namespace meniscus
