// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes when the places of an opening release particles.
#include "sdk/world/flow/emitter_clock.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meniscus {

namespace {

/// A number without a common factor with `count`, near `count` times the golden ratio's inverse. Its
/// multiples modulo `count` visit each turn once, and neighbouring places do not follow one another.
uint32_t golden_stride(uint32_t count) {
  auto stride = static_cast<uint32_t>(0.6180339887 * count) + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

}  // namespace

EmitterClock::EmitterClock(uint32_t places, double start, double stop, double period, double spread)
    : stop_(stop), period_(period) {
  const uint64_t stride = golden_stride(places);
  for (uint32_t k = 0; k < places; ++k) {
    const double turn = static_cast<double>(stride * k % places + 1) / places;
    places_.push_back({start + (1 - spread + turn * spread) * period, false});
  }
}

double EmitterClock::expected(double until) const {
  double count = 0;
  for (const Place& place : places_) {
    if (place.waits)
      count += 1;
    else
      count += std::max(0.0, (std::min(until, stop_) - place.next) / period_ + 1);
  }
  return count;
}

void EmitterClock::due(double until, std::vector<Departure>& departures) const {
  departures.clear();
  for (uint32_t k = 0; k < places_.size(); ++k) {
    if (places_[k].waits) {
      if (may_leave(until)) departures.push_back({until, k, true});
      continue;
    }
    for (double time = places_[k].next; time <= until && may_leave(time); time += period_)
      departures.push_back({time, k, false});
  }
  std::sort(departures.begin(), departures.end(), [](const Departure& a, const Departure& b) {
    return std::tie(a.time, a.place) < std::tie(b.time, b.place);
  });
}

void EmitterClock::note(const Departure& departure, bool left) {
  places_[departure.place] = {departure.time + period_, !left};
}

}  // namespace meniscus
