// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What has become of each world of a batch.
#pragma once

#include <meniscus/scene.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace meniscus::cli {

/// A table with a row for each world.
struct WorldTable {
  std::vector<std::string> columns;       ///< names, with units
  std::vector<std::vector<double>> rows;  ///< numbers, by world and column
  std::vector<std::string> hashes;        ///< of the states, by world

  void write(const std::filesystem::path& file) const;  ///< as CSV; throws Error(io)
  /// By column: the least, mean and greatest value of all worlds.
  nlohmann::ordered_json ranges() const;
  nlohmann::ordered_json json() const;
};

/// The present states of all worlds: time, whether they failed, and where fluid and bodies are and how fast.
WorldTable read_worlds(const WorldBatch& batch, const std::vector<BodyDef>& bodies);

}  // namespace meniscus::cli
