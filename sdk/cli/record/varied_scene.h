// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes that differ from one another in some numbers, for the worlds of a batch.
#pragma once

#include <meniscus/scene.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace meniscus::cli {

/// A number of a scene that differs among worlds.
struct Variation {
  std::string path;  ///< as in volumes[0].velocity[1]
  double low, high;
};

/// Reads `path=low:high`. Throws Error(invalid_argument) that names the option, also for a path to what is
/// the same in all worlds of a batch.
Variation parse_variation(const std::string& text);

/// A scene of which some numbers are random.
class VariedScene {
 public:
  /// `path`: of the scene's file. Throws Error(invalid_argument) if a path names no number.
  VariedScene(nlohmann::json document, std::string path, std::vector<Variation> variations, uint64_t seed);

  const std::vector<Variation>& variations() const { return variations_; }
  /// Whether nothing but gravity differs.
  bool varies_gravity_alone() const;
  /// The k-th number in a world: evenly spread over its range. It depends on the seed, the world and k.
  double value(uint32_t world, std::size_t k) const;
  Scene scene(uint32_t world) const;

 private:
  nlohmann::json document_;
  std::string path_;
  std::vector<Variation> variations_;
  uint64_t seed_;
};

}  // namespace meniscus::cli
