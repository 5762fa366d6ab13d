// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The solids of all worlds of a batch, from those of one.
#pragma once

#include "sdk/engine/engine_types.h"

namespace meniscus {

/// Fixed shapes stay as they are. Shapes of bodies follow world after world, as the bodies' numbers do, of
/// which a world has `bodies`.
inline SolidShapes of_all_worlds(SolidShapes one, uint32_t worlds, uint32_t bodies) {
  SolidShapes all = one;
  all.worlds = worlds;
  const auto moving = static_cast<uint32_t>(one.shapes.size()) - one.fixed;
  for (uint32_t w = 1; w < worlds; ++w) {
    for (uint32_t k = one.fixed; k < one.shapes.size(); ++k) {
      all.shapes.push_back(one.shapes[k]);
      all.shapes.back().body += w * bodies;
    }
    for (collision::CarriedShape carried : one.carried) {
      carried.shape += w * moving;
      carried.body += w * bodies;
      all.carried.push_back(carried);
    }
    for (collision::FilmPart film : one.films) {
      film.shape += w * moving;
      film.body += w * bodies;
      all.films.push_back(film);
    }
  }
  return all;
}

}  // namespace meniscus
