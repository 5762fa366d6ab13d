// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The cloth of a world as one: constraints of several pieces, and seams between them.
#pragma once

#include <span>

#include "cloth/build/build_constraints.h"

namespace meniscus::cloth {

/// All pieces as one, vertices numbered piece after piece. Colour c of the whole is colour c of every piece.
ClothConstraints merge(std::span<const ClothConstraints> pieces);

/// Adds seams to the edges, in colours that are free at both ends; edges may change theirs to make room.
/// Throws Error(invalid_argument) for a seam whose ends are one vertex or none of `all`, or whose length or
/// compliance is negative or not finite.
void add_seams(ClothConstraints& all, std::span<const EdgeConstraint> seams);

}  // namespace meniscus::cloth
