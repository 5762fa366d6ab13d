// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods and ropes as the host builds them: chains of vertices, with a segment between each two. Segments of a
// rod have a frame each (Kugelstadt & Schömer 2016), so that it bends and twists; a rope's have a length
// alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cloth/rods/elements.h"

namespace meniscus::cloth {

/// What a rod of circular cross-section is made of.
struct RodParameters {
  float radius = 0.005f;          ///< m, > 0
  float density = 1000;           ///< kg/m³, > 0
  float youngs_modulus = 1e7f;    ///< E, Pa, > 0; infinity: unyielding
  float shear_modulus = 3.5e6f;   ///< G, Pa, > 0; infinity: unyielding
  float damping = 0;              ///< s, ≥ 0, of Rayleigh's kind: damping is so many times the stiffness
  bool bends_and_twists = true;   ///< false: a rope, which has nothing but its length
  bool closed = false;            ///< the last vertex is joined to the first
  bool straight_at_rest = false;  ///< free of bending and twist when straight, however it is placed

  // Instead of what follows from the section and the moduli; > 0, infinity: unyielding
  std::optional<float> stretch_stiffness;  ///< EA, N
  std::optional<float> bending_stiffness;  ///< EI, N·m²
  std::optional<float> twist_stiffness;    ///< GJ, N·m²
};

/// Several rods, or several ropes. Vertices are numbered over all of a world, segments over the model.
struct RodModel {
  std::vector<RodChain> chains;
  std::vector<RodSegment> segments;
  std::vector<Quat> frames;   ///< of each segment as placed: z along it; none where there are ropes alone
  std::vector<float> masses;  ///< kg, of each vertex, in the order of the points

  uint32_t segment_count() const { return static_cast<uint32_t>(segments.size()); }
};

/// A rod through the points, m, in which they are at rest; its vertices are numbered from 0. Frames are
/// carried along the rod without twist. Throws Error(invalid_argument) where there are fewer than 2 points (3
/// in a loop), one that is not finite, two in a row that coincide, or a parameter outside its range.
RodModel build_rod(std::span<const Vec3> points, const RodParameters& parameters);

/// Adds `more` behind what is there, its vertices numbered from first_vertex on. Both bend, or both do not.
void append(RodModel& model, const RodModel& more, uint32_t first_vertex);

}  // namespace meniscus::cloth
