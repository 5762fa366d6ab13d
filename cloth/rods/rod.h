// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods and ropes as the host builds them: chains of vertices, with a segment between each two. Each segment
// of a rod has a frame (Kugelstadt & Schömer 2016), so that the rod bends and twists. Segments of a rope have
// a length only.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cloth/rods/elements.h"

namespace meniscus::cloth {

/// The material and shape of a rod of circular cross-section.
struct RodParameters {
  float radius = 0.005f;          ///< m, > 0
  float density = 1000;           ///< kg/m³, > 0
  float youngs_modulus = 1e7f;    ///< E, Pa, > 0; infinity: unyielding
  float shear_modulus = 3.5e6f;   ///< G, Pa, > 0; infinity: unyielding
  float damping = 0;              ///< s, ≥ 0, Rayleigh damping: the ratio of damping to stiffness
  bool bends_and_twists = true;   ///< false: a rope, which has only its length
  bool closed = false;            ///< the last vertex is joined to the first
  bool straight_at_rest = false;  ///< free of bending and twist when straight, however it is placed

  // These replace the values from section and moduli; > 0, infinity: unyielding
  std::optional<float> stretch_stiffness;  ///< EA, N
  std::optional<float> bending_stiffness;  ///< EI, N·m²
  std::optional<float> twist_stiffness;    ///< GJ, N·m²
};

/// Several rods, or several ropes. Vertices are numbered over the world, and segments over the model.
struct RodModel {
  std::vector<RodChain> chains;
  std::vector<RodSegment> segments;
  std::vector<Quat> frames;   ///< of each segment as placed, with z along it; none if there are only ropes
  std::vector<float> masses;  ///< kg, of each vertex, in the order of the points

  uint32_t segment_count() const { return static_cast<uint32_t>(segments.size()); }
};

/// Builds a rod through the points (m), which are its shape at rest. Its vertices are numbered from 0. Frames
/// are carried along the rod without twist. Throws Error(invalid_argument) for fewer than 2 points (3 in a
/// loop), or a parameter out of range. Also for a point that is not finite, or successive points that
/// coincide.
RodModel build_rod(std::span<const Vec3> points, const RodParameters& parameters);

/// The frame, turned by the least rotation that lays its z axis along a segment. It stays where the segment
/// has no length.
Quat turned_frame(Quat frame, Vec3 segment);

/// Appends `more`, with its vertices numbered from first_vertex on. Both models must bend, or neither.
void append(RodModel& model, const RodModel& more, uint32_t first_vertex);

}  // namespace meniscus::cloth
