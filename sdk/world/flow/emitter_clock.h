// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace meniscus {

/// A particle that is due at a place of an opening.
struct Departure {
  double time;         ///< s
  uint32_t place;      ///< number
  bool waits = false;  ///< it found no room before
};

/// When particles leave each place of an opening: at an even pace, unless one finds no room. It then waits,
/// alone, and leaves at the end of the first step that has room for it; from there the pace goes on.
class EmitterClock {
 public:
  /// Times in s. Each place makes a particle once in a `period`, the first no later than one has gone by
  /// since `start`; over the share `spread` of the period before that the places take turns.
  EmitterClock(uint32_t places, double start, double stop, double period, double spread);

  /// How many particles are due until then, roughly.
  double expected(double until) const;
  /// Who is due until then, in the order of time, then of places.
  void due(double until, std::vector<Departure>& departures) const;
  /// What became of a departure; to be told in the order of due().
  void note(const Departure& departure, bool left);

 private:
  struct Place {
    double next;  // s
    bool waits;
  };

  bool may_leave(double time) const { return time <= stop_ + 1e-6 * period_; }

  std::vector<Place> places_;
  double stop_, period_;
};

}  // namespace meniscus
