// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads a batch's worlds into a table, and writes it.
#include "sdk/cli/record/world_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pbd/math/vec.h"
#include "sdk/cli/record/csv_file.h"

namespace meniscus::cli {
namespace {

void add_vector(std::vector<double>& row, Vec3 v) {
  row.insert(row.end(), {double{v.x}, double{v.y}, double{v.z}});
}

/// Mean position, and mean and greatest speed; 0 if there are none.
void add_points(std::vector<double>& row, std::span<const Vec3> positions, std::span<const Vec3> velocities) {
  double centre[3] = {0, 0, 0}, mean = 0, most = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    centre[0] += double{positions[i].x};
    centre[1] += double{positions[i].y};
    centre[2] += double{positions[i].z};
    const double speed = double{length(velocities[i])};
    mean += speed;
    most = std::max(most, speed);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(positions.size(), 1));
  for (const double sum : centre) row.push_back(sum / count);
  row.push_back(mean / count);
  row.push_back(most);
}

std::string name_of(const BodyDef& body, std::size_t number) {
  return body.name.empty() ? fmt::format("body{}", number) : body.name;
}

}  // namespace

WorldTable read_worlds(const WorldBatch& batch, const std::vector<BodyDef>& bodies) {
  WorldTable table;
  table.columns = {"time_s",     "failed",         "centre_x_m",        "centre_y_m",
                   "centre_z_m", "mean_speed_m_s", "greatest_speed_m_s"};
  const std::size_t vertices = batch.vertex_count();
  if (vertices > 0) {
    for (const char* value : {"x_m", "y_m", "z_m", "mean_speed_m_s", "greatest_speed_m_s"})
      table.columns.push_back(std::string("cloth_") + value);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string name = name_of(bodies[b], b);
    for (const char* value : {"_x_m", "_y_m", "_z_m", "_speed_m_s"}) table.columns.push_back(name + value);
  }
  const std::size_t particles = batch.particle_count(), each = batch.body_count();
  const std::span<const Vec3> positions = batch.positions(), velocities = batch.velocities();
  const std::span<const BodyState> states = batch.body_states();
  for (uint32_t w = 0; w < batch.worlds(); ++w) {
    const WorldStatus& status = batch.status()[w];
    std::vector<double> row{status.time, status.failed ? 1.0 : 0.0};
    add_points(row, positions.subspan(w * particles, particles),
               velocities.subspan(w * particles, particles));
    if (vertices > 0)
      add_points(row, batch.cloth_positions().subspan(w * vertices, vertices),
                 batch.cloth_velocities().subspan(w * vertices, vertices));
    for (const BodyState& state : states.subspan(w * each, each)) {
      add_vector(row, state.pose.position);
      row.push_back(double{length(state.velocity)});
    }
    table.rows.push_back(std::move(row));
    table.hashes.push_back(fmt::format("{:016x}", batch.state_hashes()[w]));
  }
  return table;
}

void WorldTable::write(const std::filesystem::path& file) const {
  std::string text = "world";
  for (const std::string& column : columns) text.append(",").append(csv_field(column));
  CsvFile csv(file, text + ",state_hash");
  for (std::size_t w = 0; w < rows.size(); ++w) {
    text = std::to_string(w);
    for (const double value : rows[w]) text += fmt::format(",{:.9g}", value);
    csv.write(text + "," + hashes[w]);
  }
}

nlohmann::ordered_json WorldTable::ranges() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    double least = HUGE_VAL, most = -HUGE_VAL, sum = 0;
    for (const std::vector<double>& row : rows) {
      least = std::min(least, row[k]);
      most = std::max(most, row[k]);
      sum += row[k];
    }
    all[columns[k]] = {{"least", least}, {"mean", sum / static_cast<double>(rows.size())}, {"most", most}};
  }
  return all;
}

nlohmann::ordered_json WorldTable::json() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t w = 0; w < rows.size(); ++w) {
    nlohmann::ordered_json row{{"world", w}};
    for (std::size_t k = 0; k < columns.size(); ++k) row[columns[k]] = rows[w][k];
    row["state_hash"] = hashes[w];
    all.push_back(std::move(row));
  }
  return all;
}

}  // namespace meniscus::cli
