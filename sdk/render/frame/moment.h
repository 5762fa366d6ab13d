// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/views.h"

namespace meniscus::render {

/// What is to be seen at one moment; views of arrays that live elsewhere.
struct Moment {
  /// Has the particles, in place of the four spans below; drawn from where it simulates, where that draws,
  /// too.
  const World* world = nullptr;
  std::span<const Ellipsoid> ellipsoids{};     ///< World::ellipsoids
  std::span<const uint32_t> fluids{};          ///< World::fluids, one an ellipsoid
  std::span<const Vec3> positions{};           ///< World::positions; needed for balls alone
  std::span<const DiffuseParticle> diffuse{};  ///< World::diffuse
  std::span<const BodyState> bodies{};         ///< in the scene's order; none: where they start
  io::ClothFrame cloth{};
  io::RopeFrame ropes{};
  const ViewData* view = nullptr;  ///< null: as things look
};

}  // namespace meniscus::render
