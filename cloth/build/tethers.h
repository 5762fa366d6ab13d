// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tethers: limits on the distance between a vertex and a held vertex.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/build_constraints.h"
#include "cloth/build/chains.h"
#include "cloth/build/cloth_mesh.h"
#include "cloth/build/cloth_model.h"

namespace meniscus::cloth {

/// Long-range attachments (Kim, Chentanez & Müller 2012). Attaches each free vertex to the held vertex
/// nearest to it along the surface at rest, with that distance as its length. Vertices of parts without held
/// vertices get none. Tethers are in the order of anchors, then of vertices. Throws Error(invalid_argument)
/// if a number in `held` is no vertex.
///
/// A tether has the compliance L²/(A k(φ)) of a strip of the fabric from the anchor to its vertex, see
/// yield_along. A is the area that the vertex represents. All tethers together are then no stiffer than the
/// fabric. Unyielding tethers would push a load on held cloth with several times the force of stretched
/// fabric, and draw it to the nearest pins.
///
/// Distances come from fast marching over the triangles (Kimmel & Sethian 1998). So they are not those of
/// paths along edges, and never shorter than the straight line. tethers.cpp lists the departures from the
/// paper.
std::vector<Tether> build_tethers(const ClothMesh& mesh, std::span<const uint32_t> held,
                                  const FabricParameters& fabric);

/// The tethers of a model. They keep their self mass only at vertices whose chains all have free ends. Such
/// chains bear hardly any load, and a load on a few vertices would stretch the cloth around them. There a
/// load stiffens tethers in the ratio of its mass to that of the cloth, as if it covered the whole strip.
/// Tethers of vertices in no chain, or in a chain with a held vertex, follow the fabric alone. Beside chains
/// that hold, they would pull at each vertex according to its load, and stretch the edges between.
std::vector<Tether> tethers_beside(const Chains& chains, const ClothModel& model);

}  // namespace meniscus::cloth
