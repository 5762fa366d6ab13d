// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Merges the cloth of a world: the constraints of several pieces, and seams between them.
#pragma once

#include <span>

#include "cloth/build/build_constraints.h"

namespace meniscus::cloth {

/// Joins all pieces, with vertices numbered piece after piece. Colour c of the result is colour c of every
/// piece.
ClothConstraints merge(std::span<const ClothConstraints> pieces);

/// Adds seams to the edges, in colours that are free at both ends. Edges may change their colours to make
/// room. Throws Error(invalid_argument) for a seam whose ends are the same vertex or not vertices of `all`,
/// or whose length or compliance is negative or not finite.
void add_seams(ClothConstraints& all, std::span<const EdgeConstraint> seams);

}  // namespace meniscus::cloth
