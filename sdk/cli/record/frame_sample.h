// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The measured state of a world after one frame, as the tables and writers of a run take it.
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/outputs.h>

#include <optional>
#include <vector>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"
#include "sdk/io/particle_frame.h"

namespace meniscus::cli {

/// The measured state of a world after a frame's step, or before the first one.
struct FrameSample {
  int frame = 0;  ///< 1: after the first step; 0: the state before it
  StepReport step;
  Diagnostics diagnostics;
  double mass = 0;  ///< kg, of all particles, cloth and ropes
  io::ParticleFrame particles;
  io::DiffuseFrame diffuse;
  std::vector<uint64_t> emitted;                   ///< so far, in the order of the scene's emitters
  std::vector<uint64_t> taken;                     ///< so far, in the order of the scene's sinks
  std::vector<double> probes;                      ///< in the order of the scene's list
  std::vector<std::optional<Vec3>> probe_vectors;  ///< of those that have one
  std::vector<BodyState> bodies;                   ///< likewise
  io::ClothFrame cloth;
  io::RopeFrame ropes;
  io::LiquidFrame liquid;               ///< filled in if it is to be written
  std::vector<ClothState> cloths;       ///< in the order of the scene's list
  std::vector<uint32_t> welded;         ///< vertices of each piece that were merged into others
  std::vector<float> bending;           ///< of each piece, the part of its bending stiffness that it has
  std::vector<std::size_t> tears;       ///< vertices of each piece that tore in two in the step
  std::vector<Vec3> attachment_forces;  ///< N, in the order of the scene's list
};

}  // namespace meniscus::cli
