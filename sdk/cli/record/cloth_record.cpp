// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes cloths.csv and attachments.csv, and collects the summary's figures of cloth and ropes.
#include "sdk/cli/record/cloth_record.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pbd/math/vec.h"

namespace meniscus::cli {
namespace {

using json = nlohmann::ordered_json;

json json_of(Vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

ClothRecord::ClothRecord(const std::filesystem::path& folder, const Scene& scene) {
  for (const ClothDef& cloth : scene.cloths) cloth_names_.push_back(cloth.name);
  for (const RopeDef& rope : scene.ropes) rope_names_.push_back(rope.name);
  for (const SceneAttachment& attachment : scene.attachments)
    attachment_names_.push_back(attachment.def.name);
  max_stretch_.assign(cloth_names_.size(), 0);
  tears_.assign(cloth_names_.size(), 0);
  max_force_.assign(attachment_names_.size(), 0);
  if (!cloth_names_.empty()) {
    cloth_file_.emplace(folder / "cloths.csv",
                        "frame,time_s,name,mean_stretch,max_stretch,kinetic_j,volume_m3,pressure_pa,"
                        "x,y,z,px,py,pz,tears");
  }
  if (!attachment_names_.empty())
    attachment_file_.emplace(folder / "attachments.csv", "frame,time_s,name,fx,fy,fz");
}

void ClothRecord::start(const FrameSample& sample) {
  states_ = sample.cloths;
  start_lengths_ = lengths_ = sample.ropes.lengths();
  forces_ = sample.attachment_forces;
  vertices_ = sample.cloth.vertex_counts();
  triangles_ = sample.cloth.triangle_counts();
  welded_ = sample.welded;
  bending_ = sample.bending;
}

void ClothRecord::add(const FrameSample& sample) {
  states_ = sample.cloths;
  lengths_ = sample.ropes.lengths();
  forces_ = sample.attachment_forces;
  vertices_ = sample.cloth.vertex_counts();
  triangles_ = sample.cloth.triangle_counts();
  welded_ = sample.welded;
  bending_ = sample.bending;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    max_stretch_[i] = std::max(max_stretch_[i], states_[i].max_stretch);
    tears_[i] += sample.tears.at(i);
  }
  for (std::size_t i = 0; i < forces_.size(); ++i)
    max_force_[i] = std::max(max_force_[i], length(forces_[i]));
  if (cloth_file_) cloth_file_->write(cloth_rows(sample));
  if (attachment_file_) attachment_file_->write(attachment_rows(sample));
}

std::string ClothRecord::cloth_rows(const FrameSample& sample) const {
  std::string rows;
  for (std::size_t i = 0; i < sample.cloths.size(); ++i) {
    const ClothState& s = sample.cloths[i];
    if (i > 0) rows += '\n';
    rows += fmt::format("{},{:.7g},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}", sample.frame,
                        sample.particles.time, csv_field(cloth_names_[i]), s.mean_stretch, s.max_stretch,
                        s.kinetic_energy, s.volume, s.pressure);
    rows += fmt::format(",{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{}", s.centre.x, s.centre.y, s.centre.z,
                        s.momentum.x, s.momentum.y, s.momentum.z, sample.tears.at(i));
  }
  return rows;
}

std::string ClothRecord::attachment_rows(const FrameSample& sample) const {
  std::string rows;
  for (std::size_t i = 0; i < sample.attachment_forces.size(); ++i) {
    const Vec3 f = sample.attachment_forces[i];
    if (i > 0) rows += '\n';
    rows += fmt::format("{},{:.7g},{},{:.7g},{:.7g},{:.7g}", sample.frame, sample.particles.time,
                        csv_field(attachment_names_[i]), f.x, f.y, f.z);
  }
  return rows;
}

json ClothRecord::cloths() const {
  json list = json::array();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const ClothState& s = states_[i];
    list.push_back({{"name", cloth_names_[i]},
                    {"mass_kg", s.mass},
                    {"area_m2", s.area},
                    {"vertices", vertices_[i]},
                    {"triangles", triangles_[i]},
                    {"welded_vertices", welded_.at(i)},
                    {"bending_fraction", bending_.at(i)},
                    {"mean_stretch", s.mean_stretch},
                    {"max_stretch", s.max_stretch},
                    {"max_stretch_of_run", max_stretch_[i]},
                    {"kinetic_j", s.kinetic_energy},
                    {"closed", s.closed},
                    {"volume_m3", s.volume},
                    {"pressure_pa", s.pressure},
                    {"centre_m", json_of(s.centre)},
                    {"momentum_kg_m_s", json_of(s.momentum)},
                    {"tears", tears_[i]}});
  }
  return list;
}

json ClothRecord::ropes() const {
  json list = json::array();
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    list.push_back({{"name", rope_names_[i]}, {"length_m", lengths_[i]}, {"start_m", start_lengths_[i]}});
  return list;
}

json ClothRecord::attachments() const {
  json list = json::array();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    list.push_back(
        {{"name", attachment_names_[i]}, {"force_n", json_of(forces_[i])}, {"max_force_n", max_force_[i]}});
  }
  return list;
}

}  // namespace meniscus::cli
