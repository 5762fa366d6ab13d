// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/frame_table.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cerrno>

#include "sdk/io/output_file.h"

namespace meniscus::cli {
namespace {

/// As RFC 4180 has it: in quotes where a comma, a quote or a line break would be misread.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

FrameTable::FrameTable(std::filesystem::path path, const std::vector<std::string>& probe_names)
    : path_(std::move(path)) {
  errno = 0;
  stream_.open(path_, std::ios::trunc);
  if (!stream_) io::throw_io_error("write", path_);
  std::string header = "frame,time_s";
  for (std::size_t i = 0; i < stage_count; ++i)
    header += fmt::format(",ms_{}", stage_name(static_cast<Stage>(i)));
  header +=
      ",ms_step,particles,density_error_mean_percent,density_error_max_percent,kinetic_j,potential_j,"
      "contacts,"
      "max_speed,non_finite,outside,substeps,removed";
  for (const std::string& name : probe_names) header += ',' + csv_field(name);
  write_row(header);
}

void FrameTable::add(const FrameSample& sample) {
  const Diagnostics& d = sample.diagnostics;
  std::string row = fmt::format("{},{:.7g}", sample.frame, sample.particles.time);
  for (const double ms : sample.step.stage_ms) row += fmt::format(",{:.4f}", ms);
  row += fmt::format(",{:.4f},{},{:.6g},{:.6g},{:.9g},{:.9g},{},{:.6g},{},{},{},{}", sample.step.ms,
                     d.particles, 100 * d.density_error_mean, 100 * std::max(d.density_error_max, 0.0),
                     d.kinetic_energy, d.potential_energy, d.contacts, d.max_speed, d.non_finite, d.outside,
                     sample.step.substeps, sample.step.removed);
  for (const double value : sample.probes) row += fmt::format(",{:.9g}", value);
  write_row(row);
}

void FrameTable::write_row(const std::string& row) {
  errno = 0;
  stream_ << row << '\n' << std::flush;
  if (!stream_) io::throw_io_error("write", path_);
}

}  // namespace meniscus::cli
