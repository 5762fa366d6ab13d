// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the rows of frames.csv.
#include "sdk/cli/record/frame_table.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sdk/cli/record/diffuse_record.h"

namespace meniscus::cli {
namespace {

std::string header_of(const std::vector<std::string>& probe_columns) {
  std::string header = "frame,time_s";
  for (std::size_t i = 0; i < stage_count; ++i)
    header += fmt::format(",ms_{}", stage_name(static_cast<Stage>(i)));
  header +=
      ",ms_step,particles,density_error_mean_percent,density_error_max_percent,kinetic_j,potential_j,"
      "contacts,"
      "max_speed,non_finite,outside,substeps,removed,emitted,spray,foam,bubbles";
  for (const std::string& name : probe_columns) header += ',' + csv_field(name);
  return header;
}

}  // namespace

FrameTable::FrameTable(std::filesystem::path path, const std::vector<std::string>& probe_columns)
    : file_(std::move(path), header_of(probe_columns)) {}

void FrameTable::add(const FrameSample& sample) {
  const Diagnostics& d = sample.diagnostics;
  std::string row = fmt::format("{},{:.7g}", sample.frame, sample.particles.time);
  for (const double ms : sample.step.stage_ms) row += fmt::format(",{:.4f}", ms);
  row += fmt::format(",{:.4f},{},{:.6g},{:.6g},{:.9g},{:.9g},{},{:.6g},{},{},{},{},{}", sample.step.ms,
                     d.particles, 100 * d.density_error_mean, 100 * std::max(d.density_error_max, 0.0),
                     d.kinetic_energy, d.potential_energy, d.contacts, d.max_speed, d.non_finite, d.outside,
                     sample.step.substeps, sample.step.removed, sample.step.emitted);
  const DiffuseCounts diffuse = counts_of(sample.diffuse);
  row += fmt::format(",{},{},{}", diffuse.spray, diffuse.foam, diffuse.bubbles);
  for (std::size_t i = 0; i < sample.probes.size(); ++i) {
    row += fmt::format(",{:.9g}", sample.probes[i]);
    if (!sample.probe_vectors[i]) continue;
    const Vec3 v = *sample.probe_vectors[i];
    row += fmt::format(",{:.9g},{:.9g},{:.9g}", v.x, v.y, v.z);
  }
  file_.write(row);
}

}  // namespace meniscus::cli
