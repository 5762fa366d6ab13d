// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The walls of a container for rigid bodies.
#pragma once

#include <meniscus/defs.h>

#include <vector>

#include "collision/rigid/rigid_world.h"

namespace meniscus {

/// A container's walls as boxes with a thickness, for solids. Its openings stay open.
std::vector<collision::RigidPart> container_walls(const ContainerGeometry& container);

}  // namespace meniscus
