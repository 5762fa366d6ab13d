// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds of each kind that a batch may have copies of.
#pragma once

#include "tests/cloth_worlds.h"
#include "tests/worlds.h"

namespace meniscus::tests {

/// Two fluids that fall apart around a ball, in a tank with friction that is open above.
World fluids(const WorldDef& def);

/// A block of water that falls apart around a box on the floor, a float, two bodies on a hinge, and a paddle.
struct Pool {
  World world;
  BodyId box, ball, arm, paddle;
};
Pool pool(const WorldDef& def);

/// Water that falls on a sheet held at its corners; a sheet with strains of triangles and dihedral bending,
/// whose edge is sewn to it; a disc that falls on a ball; a balloon; gusts.
World washing(WorldDef def);

/// A sheet that falls on its edge and folds, and two that fly at one another, one of them fast.
World folding(const WorldDef& def);

/// A ball and water that fall into a net; a crate that hangs from a sheet, with a float on a hinge; a curtain
/// on a kinematic rod; a box on a rug.
struct Rigging {
  World world;
  BodyId ball, crate, rod, box;
};
Rigging rigging(WorldDef def);

/// Sand that falls onto a ball, a box and a floor.
World sandpit(const WorldDef& def);

ClothDef without_self_collision(ClothDef cloth);

}  // namespace meniscus::tests
