// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the renderer draws at one moment.
#pragma once

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/views.h"

namespace meniscus::render {

/// The objects at one moment, as views of arrays that live elsewhere.
struct Moment {
  /// World with the particles, in place of the five spans below. If OpenGL draws on the device that
  /// simulates, the particles are not copied through the host.
  const World* world = nullptr;
  std::span<const Ellipsoid> ellipsoids{};     ///< World::ellipsoids
  std::span<const uint32_t> fluids{};          ///< World::fluids, one per ellipsoid
  std::span<const Vec3> positions{};           ///< World::positions; needed for balls alone
  std::span<const Vec3> velocities{};          ///< World::velocities; empty: drops are not stretched
  std::span<const DiffuseParticle> diffuse{};  ///< World::diffuse
  std::span<const BodyState> bodies{};         ///< in the scene's order; empty: at their start
  io::ClothFrame cloth{};
  io::RopeFrame ropes{};
  const ViewData* view = nullptr;  ///< null: the normal picture
};

}  // namespace meniscus::render
