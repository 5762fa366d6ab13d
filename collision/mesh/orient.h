// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Turns faces so that neighbours agree on the side that they show: along edges that two faces share, where
/// the most faces of a connected part keep their side. Closed parts are then turned outwards, or inwards
/// where they lie wholly inside an odd number of other closed parts: the inner shell of a hollow body. A part
/// that has but one side (Möbius' strip) keeps an edge on which its faces disagree.
void orient_faces(TriangleMesh& mesh);

}  // namespace meniscus::collision
