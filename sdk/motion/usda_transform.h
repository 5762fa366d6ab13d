// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Evaluates the transforms of prims over time.
#pragma once

#include <meniscus/bodies.h>

#include <string>
#include <vector>

#include "sdk/motion/usda.h"

namespace meniscus::motion {

/// The pose of a prim in the frame of its layer, m and s: the product of its operations and of those of all
/// above it. There is one at each time code with a sample. Where operations turn by more than a tuned angle
/// from one to the next there are more, as keyframes take the shortest way. An empty path stands for the only
/// prim with samples. Throws FileDefect if there is no such prim, if nothing moves it, or if an operation is
/// not known, scales, or is not finite.
std::vector<Keyframe> poses_of(const UsdaLayer& layer, const std::string& path);

}  // namespace meniscus::motion
