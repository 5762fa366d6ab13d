// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Improves a colouring: removes small colours, and balances the sizes of the others.
#pragma once

#include <algorithm>
#include <bit>
#include <deque>

#include "cloth/build/incidence.h"
#include "cloth/build/topology.h"
#include "cloth/build/tuning.h"

namespace meniscus::cloth {

inline uint32_t count_of(const std::vector<uint32_t>& colours) {
  return colours.empty() ? 0 : *std::max_element(colours.begin(), colours.end()) + 1;
}

/// Improves a colouring with at most `most_colours` colours by moving single constraints.
template <size_t Arity>
class Recolouring {
 public:
  static constexpr uint32_t most_colours = 64;  // the bits of a word

  Recolouring(Corners<Arity> corners, const Incidence& incidence, std::vector<uint32_t>& colours)
      : corners_(corners),
        incidence_(incidence),
        colours_(colours),
        count_(count_of(colours)),
        sizes_(count_, 0),
        used_(incidence.starts.size() - 1, 0) {
    for (uint32_t i = 0; i < corners_.size(); ++i) give(i, colours_[i]);
  }

  /// Removes small colours, since a colour of few constraints costs a GPU as many launches as a large one.
  void dissolve_small_colours() {
    while (count_ > incidence_.most_at_a_vertex() && dissolve_smallest()) {
    }
  }

  /// Moves constraints from colours above the mean size to colours below it.
  void balance() {
    const auto fraction = static_cast<uint32_t>((corners_.size() + count_ - 1) / count_);
    for (uint32_t i = 0; i < corners_.size(); ++i) {
      if (sizes_[colours_[i]] <= fraction) continue;
      uint32_t best = colours_[i];
      for (uint64_t free = free_for(i); free != 0; free &= free - 1) {
        const auto colour = static_cast<uint32_t>(std::countr_zero(free));
        if (sizes_[colour] < fraction && sizes_[colour] < sizes_[best]) best = colour;
      }
      if (best != colours_[i]) move(i, best);
    }
  }

 private:
  void give(uint32_t i, uint32_t colour) {
    colours_[i] = colour;
    ++sizes_[colour];
    for (uint32_t v : corners_[i]) used_[v] |= uint64_t{1} << colour;
  }
  void take(uint32_t i) {
    --sizes_[colours_[i]];
    for (uint32_t v : corners_[i]) used_[v] &= ~(uint64_t{1} << colours_[i]);
    colours_[i] = none;
  }
  void move(uint32_t i, uint32_t colour) {
    take(i);
    give(i, colour);
  }

  /// The colours that constraint i could have.
  uint64_t free_for(uint32_t i) const {
    uint64_t used = 0;
    for (uint32_t v : corners_[i]) used |= used_[v];
    return ~used & (~uint64_t{0} >> (64 - count_));
  }

  /// The constraint of this colour at this vertex, or none.
  uint32_t holder(uint32_t vertex, uint32_t colour) const {
    if (!(used_[vertex] >> colour & 1)) return none;
    for (uint32_t i : incidence_.at(vertex)) {
      if (colours_[i] == colour) return i;
    }
    return none;
  }

  /// Divides the smallest colour among the others. Returns false and changes nothing if that takes too long,
  /// or if the colour is not small.
  bool dissolve_smallest() {
    const auto smallest =
        static_cast<uint32_t>(std::min_element(sizes_.begin(), sizes_.end()) - sizes_.begin());
    const uint32_t size = sizes_[smallest];
    if (colouring_tuning::small_colour * size * count_ > corners_.size()) return false;
    const Recolouring before = *this;
    const std::vector<uint32_t> colours_before = colours_;
    std::deque<uint32_t> homeless = remove_colour(smallest);
    const size_t most_steps =
        corners_.size() / colouring_tuning::constraints_a_step + colouring_tuning::steps_a_constraint * size;
    std::vector<uint32_t> placed(corners_.size(), 0);
    for (uint32_t step = 1; !homeless.empty(); ++step) {
      if (step > most_steps) {
        colours_ = colours_before;
        restore(before);
        return false;
      }
      const uint32_t i = homeless.front();
      homeless.pop_front();
      displace(i, colour_to_force(i, placed, step), homeless);
      placed[i] = step;
    }
    return true;
  }

  void restore(const Recolouring& before) {
    count_ = before.count_;
    sizes_ = before.sizes_;
    used_ = before.used_;
  }

  /// Removes a colour, whose number goes to the last colour. Returns the constraints that have none now.
  std::deque<uint32_t> remove_colour(uint32_t colour) {
    std::deque<uint32_t> homeless;
    std::vector<uint32_t> renamed;
    for (uint32_t i = 0; i < corners_.size(); ++i) {
      if (colours_[i] == colour) homeless.push_back(i);
      if (colours_[i] == count_ - 1 && colour != count_ - 1) renamed.push_back(i);
    }
    for (uint32_t i : homeless) take(i);
    for (uint32_t i : renamed) move(i, colour);
    sizes_.resize(--count_);
    return homeless;
  }

  /// The colour for constraint i that displaces the fewest others. It prefers to displace constraints that
  /// have another free colour, or that have kept theirs for long.
  uint32_t colour_to_force(uint32_t i, const std::vector<uint32_t>& placed, uint32_t step) const {
    if (const uint64_t free = free_for(i)) return static_cast<uint32_t>(std::countr_zero(free));
    uint32_t best = 0;
    uint64_t best_cost = ~uint64_t{0};
    for (uint32_t k = 0; k < count_; ++k) {
      const uint32_t colour = (k + step) % count_;  // so that equal costs do not repeat in cycles
      uint64_t cost = 0;
      for (uint32_t v : corners_[i]) {
        const uint32_t other = holder(v, colour);
        if (other == none) continue;
        const uint32_t age = placed[other] == 0 ? colouring_tuning::recent
                                                : std::min(colouring_tuning::recent, step - placed[other]);
        cost += (free_for(other) != 0 ? 1 : colouring_tuning::homeless_cost) +
                colouring_tuning::recent_cost * (colouring_tuning::recent - age);
      }
      if (cost < best_cost) {
        best_cost = cost;
        best = colour;
      }
    }
    return best;
  }

  void displace(uint32_t i, uint32_t colour, std::deque<uint32_t>& homeless) {
    for (uint32_t v : corners_[i]) {
      const uint32_t other = holder(v, colour);
      if (other == none) continue;
      take(other);
      homeless.push_back(other);
    }
    give(i, colour);
  }

  Corners<Arity> corners_;
  const Incidence& incidence_;
  std::vector<uint32_t>& colours_;
  uint32_t count_;
  std::vector<uint32_t> sizes_;
  std::vector<uint64_t> used_;  // by vertex, one bit per colour
};

}  // namespace meniscus::cloth
