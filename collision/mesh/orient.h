// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Consistent orientation of faces, outwards for closed parts.
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Orients faces so that neighbours agree, along edges that two faces share. In each connected part, the
/// orientation of most faces stays. Closed parts are then turned outwards. A closed part that lies wholly
/// inside an odd number of other closed parts is turned inwards: it is the inner shell of a hollow body. A
/// part with only one side (a Möbius strip) keeps an edge at which its faces disagree.
void orient_faces(TriangleMesh& mesh);

}  // namespace meniscus::collision
