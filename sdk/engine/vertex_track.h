// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where the vertices of a driven surface are over time.
#pragma once

#include <meniscus/types.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "pbd/math/vec.h"

namespace meniscus {

struct VertexTrack {
  std::vector<double> times;    ///< s, ascending; at least one
  std::vector<Vec3> positions;  ///< m, frame by frame
  bool loop = false;            ///< the first frame follows the last

  uint32_t frames() const { return static_cast<uint32_t>(times.size()); }
  uint32_t vertices() const { return static_cast<uint32_t>(positions.size() / times.size()); }
};
using VertexTrackPtr = std::shared_ptr<const VertexTrack>;

/// A place between a frame and the next.
struct TrackPlace {
  uint32_t frame, next;
  float fraction;  ///< 0: at the frame
};

/// By the rules of keyframes of bodies (collision::keyframe_pose).
inline TrackPlace place_at(const VertexTrack& track, double time) {
  const double first = track.times.front(), last = track.times.back();
  if (track.loop && time > last && last > first) time = first + std::fmod(time - first, last - first);
  if (time <= first) return {0, 0, 0};
  if (time >= last) return {track.frames() - 1, track.frames() - 1, 0};
  const auto next = static_cast<uint32_t>(std::ranges::upper_bound(track.times, time) - track.times.begin());
  const double before = track.times[next - 1];
  return {next - 1, next, static_cast<float>((time - before) / (track.times[next] - before))};
}

MENISCUS_HD inline Vec3 on_way(Vec3 from, Vec3 to, float fraction) {
  return from + fraction * (to - from);
}

/// m, at a time.
inline std::vector<Vec3> positions_at(const VertexTrack& track, double time) {
  const TrackPlace place = place_at(track, time);
  const Vec3* from = &track.positions[size_t{place.frame} * track.vertices()];
  const Vec3* to = &track.positions[size_t{place.next} * track.vertices()];
  std::vector<Vec3> positions(track.vertices());
  for (size_t v = 0; v < positions.size(); ++v) positions[v] = on_way(from[v], to[v], place.fraction);
  return positions;
}

/// m/s, by frame: the greatest speed of a vertex on the way to the next. 0 for the last.
inline std::vector<float> speeds_of(const VertexTrack& track) {
  std::vector<float> speeds(track.frames());
  const size_t vertices = track.vertices();
  for (size_t f = 0; f + 1 < track.frames(); ++f) {
    float furthest = 0;
    for (size_t v = f * vertices; v < (f + 1) * vertices; ++v)
      furthest = std::max(furthest, length(track.positions[v + vertices] - track.positions[v]));
    speeds[f] = furthest / static_cast<float>(track.times[f + 1] - track.times[f]);
  }
  return speeds;
}

/// The vertices of one piece.
struct DrivenPiece {
  uint32_t first = 0;  ///< vertex
  VertexTrackPtr track;
};

}  // namespace meniscus
