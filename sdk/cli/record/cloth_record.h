// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The figures of a run's cloth, ropes and attachments.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/record/csv_file.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// The figures of a run's cloth, ropes and attachments. With cloth, cloths.csv has one row per frame and
/// piece. It lists stretch: the mean of |l/L − 1| and the largest l/L over the edges. It lists kinetic
/// energy, volume and overpressure (of closed pieces), centre of mass (m) and momentum (kg·m/s). It also
/// lists how many vertices tore in two in the frame. With attachments, attachments.csv lists the force at
/// each, in N.
class ClothRecord {
 public:
  /// Throws Error(io).
  ClothRecord(const std::filesystem::path& folder, const Scene& scene);

  /// The state before the first step.
  void start(const FrameSample& sample);
  /// The state after a step. Throws Error(io).
  void add(const FrameSample& sample);

  /// The last state of each piece, its largest stretch in the run, and its number of tears.
  nlohmann::ordered_json cloths() const;
  /// The last length of each rope, and its length at the start.
  nlohmann::ordered_json ropes() const;
  /// The last force on each attachment, and the largest in the run.
  nlohmann::ordered_json attachments() const;

 private:
  std::string cloth_rows(const FrameSample& sample) const;
  std::string attachment_rows(const FrameSample& sample) const;

  std::vector<std::string> cloth_names_, rope_names_, attachment_names_;
  std::optional<CsvFile> cloth_file_, attachment_file_;

  // Of the last frame.
  std::vector<ClothState> states_;
  std::vector<std::size_t> vertices_, triangles_;
  std::vector<uint32_t> welded_;
  std::vector<float> bending_;
  std::vector<double> lengths_;  // m, of the ropes
  std::vector<Vec3> forces_;

  // Over all frames so far.
  std::vector<float> max_stretch_, max_force_;
  std::vector<std::size_t> tears_;

  std::vector<double> start_lengths_;
};

}  // namespace meniscus::cli
