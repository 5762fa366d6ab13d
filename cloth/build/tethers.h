// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/chains.h"
#include "cloth/build/cloth_mesh.h"
#include "cloth/build/cloth_model.h"

namespace meniscus::cloth {

/// Long-range attachments (Kim, Chentanez & Müller 2012): ties each vertex that is not held to the held
/// vertex nearest to it along the surface at rest, with that distance as its length. Vertices of parts that
/// nothing holds get none. In the order of anchors, then of vertices. Throws Error(invalid_argument) where a
/// number in `held` is no vertex.
///
/// A tether gives way as a strip of the fabric would that leads there, with the area A that its vertex stands
/// for: by L²/(A k(φ)), see yield_along. All together are then no stiffer than the fabric. Unyielding, they
/// push at what lies on held cloth with several times the force that its stretch takes, and draw it to the
/// nearest pins.
///
/// Distances by fast marching over the triangles (Kimmel & Sethian 1998), so that they are not those of paths
/// along edges, and never shorter than the straight line. Where the code departs from the paper: tethers.cpp.
std::vector<Tether> build_tethers(const ClothMesh& mesh, std::span<const uint32_t> held,
                                  const FabricParameters& fabric);

/// With the own masses of those vertices alone whose chains all end free: these bear hardly anything, and
/// what lies on a few vertices would stretch what is around them. Under a load tethers there are as much
/// stiffer as it is heavier than cloth, as if it were all over the strip. Who is in no chain, and who is in
/// one that leads to what is held, has tethers that go by the fabric alone: beside chains that hold they
/// would pull at each vertex by what lies on it, and stretch the edges between.
std::vector<Tether> tethers_beside(const Chains& chains, const ClothModel& model);

}  // namespace meniscus::cloth
