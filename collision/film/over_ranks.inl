// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the ranks of a shared world merge what each has found of the fluid beside films. Each place is in the
// region of one rank, and the others have 0 for it. So the bits of numbers can be added up as integers.
#pragma once

#include <meniscus/error.h>

#include <bit>
#include <vector>

#include "collision/film/film_set.h"

namespace meniscus::collision {

/// The pressures beside vertices, and which bodies have films.
template <class D>
void FilmSet<D>::merge_rims(pbd::GhostExchange& ranks) {
  std::vector<film_kernels::RimPoint> rims = rims_.read(rims_.size());
  std::vector<uint32_t> has_film = has_film_.read(has_film_.size());
  std::vector<uint64_t> all(has_film.begin(), has_film.end());
  for (const film_kernels::RimPoint& rim : rims) {
    const uint64_t density = std::bit_cast<uint32_t>(rim.density);
    all.insert(all.end(),
               {density << 32 | std::bit_cast<uint32_t>(rim.pressure), std::bit_cast<uint32_t>(rim.wetness)});
  }
  ranks.add_up(all);
  const uint64_t* next = all.data();
  for (uint32_t& has : has_film) has = *next++ > 0;
  for (film_kernels::RimPoint& rim : rims) {
    rim.pressure = std::bit_cast<float>(static_cast<uint32_t>(*next));
    rim.density = std::bit_cast<float>(static_cast<uint32_t>(*next++ >> 32));
    rim.wetness = std::bit_cast<float>(static_cast<uint32_t>(*next++));
  }
  rims_.write(rims);
  has_film_.write(has_film);
}

/// How wet exposed triangles are, where no other face says so.
template <class D>
void FilmSet<D>::merge_wet_faces(pbd::GhostExchange& ranks) {
  std::vector<film_kernels::Gap> gaps = gaps_.read(gaps_.size());
  std::vector<uint64_t> all;
  for (const film_kernels::Gap& gap : gaps)
    all.push_back(gap.shape == pbd::no_index ? std::bit_cast<uint32_t>(gap.wet) : 0);
  ranks.add_up(all);
  for (size_t n = 0; n < gaps.size(); ++n) {
    if (gaps[n].shape == pbd::no_index) gaps[n].wet = std::bit_cast<float>(static_cast<uint32_t>(all[n]));
  }
  gaps_.write(gaps);
}

/// What particles exert on bodies with films.
template <class D>
void FilmSet<D>::merge_particle_loads(pbd::GhostExchange& ranks) {
  constexpr size_t values = 4;
  constexpr int64_t most = int64_t{1} << 53;  // so that those of 1,024 ranks have room
  std::vector<film_kernels::ParticleLoad> loads = particle_loads_.read(particle_loads_.size());
  std::vector<uint64_t> all{0};  // first, how many sums are too large
  for (const film_kernels::ParticleLoad& load : loads) {
    for (const int64_t value : {load.up.sum, load.up.first, load.up.second, load.across}) {
      all[0] += value <= -most || value >= most;
      all.push_back(static_cast<uint64_t>(value));
    }
  }
  ranks.add_up(all);
  if (all[0])
    throw Error(ErrorCode::capacity,
                "particles push bodies with films harder than sums over ranks have "
                "room for, which is 2e6 N·s in a substep");
  for (size_t b = 0; b < loads.size(); ++b) {
    const auto value = [&](size_t k) { return static_cast<int64_t>(all[1 + values * b + k]); };
    loads[b] = {{value(0), value(1), value(2)}, value(3)};
  }
  particle_loads_.write(loads);
}

}  // namespace meniscus::collision
