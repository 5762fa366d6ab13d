// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Collects the figures of a run, and writes them at its end.
#include "sdk/cli/record/run_recorder.h"

#include <spdlog/fmt/fmt.h>

#include <meniscus/version.h>
#include <algorithm>
#include <cmath>

#include "sdk/cli/record/json_text.h"
#include "sdk/fields/probes.h"
#include "sdk/fields/world.h"
#include "sdk/files/output_file.h"
#include "sdk/io/line_chart.h"

namespace meniscus::cli {
namespace {

/// A vector has its length and its components.
std::vector<std::string> probe_columns(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneProbe& probe : scene.probes) {
    names.push_back(probe.def.name);
    if (!is_vector(probe.def.kind)) continue;
    for (const char* axis : {"_x", "_y", "_z"}) names.push_back(probe.def.name + axis);
  }
  return names;
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodyDef& body : bodies_of(scene)) names.push_back(body.name);
  return names;
}

/// The word of an enumerator in a scene file.
template <class E>
const char* word_of(E value) {
  const auto names = names_of(value);
  return std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.value == value; })->name;
}

nlohmann::ordered_json json_of(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// Counts by the names of objects of the scene.
template <class Things>
nlohmann::ordered_json by_name(const Things& things, const std::vector<uint64_t>& counts) {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) values[things[i].def.name] = counts[i];
  return values;
}

void add(Overflows& sum, const Overflows& step) {
  sum.cloth_layers += step.cloth_layers;
  sum.cloth_vertices += step.cloth_vertices;
  sum.fluid_failsafe += step.fluid_failsafe;
  sum.cloth_failsafe += step.cloth_failsafe;
  sum.emitter_hold += step.emitter_hold;
}

}  // namespace

// The histogram resolves a thousandth of a percent, up to a density twice that at rest.
RunRecorder::RunRecorder(std::filesystem::path folder, const Scene& scene)
    : folder_(std::move(folder)),
      scene_(scene),
      table_(folder_ / "frames.csv", probe_columns(scene)),
      cloth_(folder_, scene),
      diffuse_(scene),
      energy_(scene),
      checks_(scene),
      density_error_(1e-5, 100'000),
      body_names_(body_names(scene)) {
  if (!body_names_.empty()) body_table_.emplace(folder_ / "bodies.csv", body_names_);
}

void RunRecorder::start(const DeviceInfo& device, const FrameSample& sample, std::vector<BodyMass> masses) {
  device_ = device;
  masses_ = std::move(masses);
  bodies_ = sample.bodies;
  diagnostics_ = sample.diagnostics;
  cloth_.start(sample);
  energy_.add(sample);
  checks_.start(sample);
}

void RunRecorder::add(const FrameSample& sample) {
  step_ = sample.step;
  diagnostics_ = sample.diagnostics;
  probes_ = sample.probes;
  bodies_ = sample.bodies;
  time_.push_back(sample.particles.time);
  density_mean_.push_back(diagnostics_.density_error_mean);
  density_max_.push_back(diagnostics_.density_error_max);
  step_ms_.push_back(step_.ms);
  for (std::size_t i = 0; i < stage_count; ++i) stage_ms_[i].push_back(step_.stage_ms[i]);
  for (const float c : sample.particles.density_errors) {
    const double error = std::isfinite(c) ? std::max(0.0f, c) : 0.0f;
    density_error_.add(error);
    density_sum_ += error;
  }
  interior_sum_ += diagnostics_.density_error_interior;
  density_iterations_ += step_.density_iterations * step_.substeps;
  substeps_ += static_cast<uint64_t>(step_.substeps);
  removed_ += step_.removed;
  emitted_ += step_.emitted;
  emitted_by_ = sample.emitted;
  taken_by_ = sample.taken;
  outside_ = std::max(outside_, diagnostics_.outside);
  non_finite_ = std::max(non_finite_, diagnostics_.non_finite);
  wall_overflows_ = std::max(wall_overflows_, diagnostics_.wall_overflows);
  cli::add(overflows_, step_.overflows);
  cloth_.add(sample);
  diffuse_.add(sample);
  energy_.add(sample);
  checks_.add(sample, energy_.ratio());
  table_.add(sample);
  if (body_table_) body_table_->add(sample);
}

nlohmann::ordered_json RunRecorder::finish(const RunEnd& end) {
  nlohmann::ordered_json figures = summary(end);
  io::OutputFile file(folder_ / "summary.json");
  file.write(json_text(figures));
  file.commit();
  if (!scene_.fluids.empty()) {
    io::write_density_svg(folder_ / "density.svg",
                          {scene_.name + ": density error", time_, density_mean_, density_max_});
  }
  return figures;
}

nlohmann::ordered_json RunRecorder::summary(const RunEnd& end) const {
  return {{"scene", scene_.name},
          {"description", scene_.description},
          {"version", MENISCUS_VERSION_STRING},
          {"device", {{"kind", device_.kind}, {"name", device_.name}, {"reason", device_.reason}}},
          {"particles", diagnostics_.particles},
          {"frames", time_.size()},
          {"steps", time_.size()},
          {"substeps", substeps_},
          {"iterations", step_.iterations},
          {"density_solver", word_of(scene_.world.density.solver)},
          {"density_iterations", density_iterations_ / static_cast<double>(std::max<uint64_t>(1, substeps_))},
          {"time_step_s", without_noise(scene_.frame_time)},
          {"simulated_s", time_.empty() ? 0.0 : without_noise(time_.back())},
          {"ms_per_step", times()},
          {"density_error", density()},
          {"energy", energy_.summary()},
          {"outside", outside_},
          {"non_finite", non_finite_},
          {"overflows", overflows()},
          {"removed", removed_},
          {"emitted", emitted_},
          {"diffuse", diffuse_.summary()},
          {"contacts", diagnostics_.contacts},
          {"device_bytes", end.device_bytes},
          {"emitters", by_name(scene_.emitters, emitted_by_)},
          {"sinks", by_name(scene_.sinks, taken_by_)},
          {"probes", probes()},
          {"bodies", bodies()},
          {"cloths", cloth_.cloths()},
          {"ropes", cloth_.ropes()},
          {"attachments", cloth_.attachments()},
          {"checks", checks_.summary()},
          {"interrupted", end.interrupted},
          {"error", end.error.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(end.error)},
          {"state_hash", fmt::format("{:016x}", end.state_hash)}};
}

nlohmann::ordered_json RunRecorder::times() const {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < stage_count; ++i) {
    stages[stage_name(static_cast<Stage>(i))] = percentile(stage_ms_[i], 0.5);
  }
  return {{"median", percentile(step_ms_, 0.5)}, {"p90", percentile(step_ms_, 0.9)}, {"stages", stages}};
}

/// Null without a fluid.
nlohmann::ordered_json RunRecorder::density() const {
  if (scene_.fluids.empty()) return nullptr;
  const double values = std::max<double>(1, static_cast<double>(density_error_.total()));
  const double frames = std::max<double>(1, static_cast<double>(time_.size()));
  return {{"unit", "percent"},
          {"mean", 100 * density_sum_ / values},
          {"p99", 100 * density_error_.percentile(0.99)},
          {"max", 100 * density_error_.largest()},
          {"interior_mean", 100 * interior_sum_ / frames}};
}

nlohmann::ordered_json RunRecorder::probes() const {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < probes_.size(); ++i) values[scene_.probes[i].def.name] = probes_[i];
  return values;
}

/// Sums over the run; of walls the most of any frame.
nlohmann::ordered_json RunRecorder::overflows() const {
  return {{"cloth_layers", overflows_.cloth_layers},     {"cloth_vertices", overflows_.cloth_vertices},
          {"fluid_failsafe", overflows_.fluid_failsafe}, {"cloth_failsafe", overflows_.cloth_failsafe},
          {"emitter_hold", overflows_.emitter_hold},     {"walls", wall_overflows_}};
}

/// The last state of each body, and its constants.
nlohmann::ordered_json RunRecorder::bodies() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState& body = bodies_[i];
    const Quat q = body.pose.rotation;
    list.push_back({{"name", body_names_[i]},
                    {"mass_kg", masses_.at(i).mass},
                    {"volume_m3", masses_.at(i).volume},
                    {"position_m", json_of(body.pose.position)},
                    {"rotation", {q.x, q.y, q.z, q.w}},
                    {"velocity_m_s", json_of(body.velocity)},
                    {"angular_velocity_rad_s", json_of(body.angular_velocity)},
                    {"fluid_force_n", json_of(body.fluid_force)},
                    {"fluid_torque_n_m", json_of(body.fluid_torque)},
                    {"awake", body.awake}});
  }
  return list;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace meniscus::cli
