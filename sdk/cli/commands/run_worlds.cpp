// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus run --worlds`: steps copies of a scene at once and writes a table of them.
#include "sdk/cli/commands/run_worlds.h"

#include <fmt/format.h>
#include <meniscus/batch.h>
#include <meniscus/error.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/commands/progress.h"
#include "sdk/cli/commands/run_files.h"
#include "sdk/cli/output/folder_lock.h"
#include "sdk/cli/output/frame_exporter.h"
#include "sdk/cli/output/old_results.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/cli/record/varied_scene.h"
#include "sdk/cli/record/world_table.h"
#include "sdk/cli/stop/interrupt.h"
#include "sdk/files/output_file.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {
namespace {

/// With the sums that a batch needs.
SceneChoice batch_choice(SceneChoice choice) {
  choice.overrides.push_back("world.sums=fixed");
  return choice;
}

/// Without what only looks on: diffuse particles, probes, and the checks that may ask for them.
Scene for_batch(Scene scene) {
  scene.world.diffuse.reset();
  scene.probes.clear();
  scene.checks.clear();
  return scene;
}

void say_what_is_left_out(const Scene& scene) {
  if (scene.world.diffuse) spdlog::warn("diffuse particles are left out");
  if (!scene.probes.empty()) spdlog::warn("probes are left out");
  if (!scene.checks.empty()) spdlog::warn("checks are left out");
}

VariedScene varied(const RunOptions& options) {
  std::vector<Variation> variations;
  for (const std::string& text : options.vary) variations.push_back(parse_variation(text));
  return {chosen_document(batch_choice(options.scene)), scene_path(options.scene.scene), variations,
          options.seed};
}

class WorldsRun {
 public:
  explicit WorldsRun(const RunOptions& options)
      : varied_(varied(options)),
        given_(chosen_scene(batch_choice(options.scene))),
        scene_(for_batch(given_)),
        folder_(results_folder(options, scene_)),
        frames_(options.frames.value_or(scene_.frames)),
        batch_(build_scene(scene_).world, {static_cast<uint32_t>(*options.worlds)}) {
    say_what_is_left_out(given_);
    vary();
    make_folder(folder_);
    lock_.emplace(folder_);
    remove_old_results(folder_);  // after all that may fail
  }

  void step(bool quiet) {
    const Interrupt interrupt;
    Progress progress(frames_, quiet);
    for (int frame = 1; frame <= frames_ && !interrupt.raised(); ++frame) {
      const BatchReport report = batch_.step(scene_.frame_time);
      ms_ += report.ms;
      stepped_ += report.stepped;
      progress.show(frame, report.ms, std::nullopt);
    }
    interrupted_ = interrupt.raised();
  }

  nlohmann::ordered_json write() const {
    WorldTable table = read_worlds(batch_, bodies_of(scene_));
    for (std::size_t k = 0; k < varied_.variations().size(); ++k) add_column(table, k);
    table.write(folder_ / "worlds.csv");
    nlohmann::ordered_json figures = summary(table);
    nlohmann::ordered_json whole = figures;
    whole["table"] = table.json();
    io::OutputFile file(folder_ / "worlds.json");
    file.write(json_text(whole));
    file.commit();
    figures["folder"] = folder_.string();
    return figures;
  }

  bool interrupted() const { return interrupted_; }

 private:
  /// Gravity is a number of a world. Anything else needs a world that was built with it.
  void vary() {
    if (varied_.variations().empty()) return;
    std::vector<Vec3> gravities;
    for (uint32_t w = 0; w < batch_.worlds(); ++w) {
      const Scene own = for_batch(varied_.scene(w));
      if (!varied_.varies_gravity_alone()) insert(w, own);
      gravities.push_back(own.world.gravity);
    }
    batch_.set_gravities(gravities);
  }

  void insert(uint32_t world, const Scene& own) {
    try {
      batch_.insert(world, build_scene(own).world);
    } catch (const Error& error) {
      std::string values;
      for (std::size_t k = 0; k < varied_.variations().size(); ++k)
        values += fmt::format("{}{} = {:.6g}", k ? ", " : "", varied_.variations()[k].path,
                              varied_.value(world, k));
      throw Error(error.code(), fmt::format("world {} with {}: {}", world, values, error.what()));
    }
  }

  /// The varied numbers stand before the results.
  void add_column(WorldTable& table, std::size_t k) const {
    const auto at = static_cast<std::ptrdiff_t>(k);
    table.columns.insert(table.columns.begin() + at, varied_.variations()[k].path);
    for (std::size_t w = 0; w < table.rows.size(); ++w)
      table.rows[w].insert(table.rows[w].begin() + at, varied_.value(static_cast<uint32_t>(w), k));
  }

  nlohmann::ordered_json summary(const WorldTable& table) const {
    const auto failed = std::count_if(batch_.status().begin(), batch_.status().end(),
                                      [](const WorldStatus& s) { return s.failed; });
    const DeviceInfo device = batch_.device();
    return {{"scene", scene_.name},
            {"device", {{"kind", device.kind}, {"name", device.name}}},
            {"worlds", batch_.worlds()},
            {"particles", batch_.particle_count()},
            {"bodies", batch_.body_count()},
            {"cloth_vertices", batch_.vertex_count()},
            {"frames", frames_},
            {"time_step_s", without_noise(double{scene_.frame_time})},
            {"interrupted", interrupted_},
            {"failed", failed},
            {"ms", ms_},
            {"steps_per_second", ms_ > 0 ? 1000 * static_cast<double>(stepped_) / ms_ : 0},
            {"device_bytes", batch_.memory_stats().device.bytes},
            {"results", table.ranges()}};
  }

  VariedScene varied_;
  Scene given_, scene_;
  std::filesystem::path folder_;
  int frames_;
  WorldBatch batch_;
  std::optional<FolderLock> lock_;
  double ms_ = 0;
  uint64_t stepped_ = 0;
  bool interrupted_ = false;
};

void print(const nlohmann::ordered_json& figures, const std::filesystem::path& folder) {
  std::string text = fmt::format(
      "{} on {}: {}\n{} worlds of {} particles and {} bodies, {} frames of {:.4g} ms\n{:.4g} s, {:.5g} steps "
      "of a world a second; {} worlds failed\n{:32}{:>14}{:>14}{:>14}\n",
      figures.at("scene").get<std::string>(), figures.at("device").at("kind").get<std::string>(),
      figures.at("device").at("name").get<std::string>(), figures.at("worlds").get<uint64_t>(),
      figures.at("particles").get<uint64_t>(), figures.at("bodies").get<uint64_t>(),
      figures.at("frames").get<int>(), 1000 * figures.at("time_step_s").get<double>(),
      figures.at("ms").get<double>() / 1000, figures.at("steps_per_second").get<double>(),
      figures.at("failed").get<uint64_t>(), "", "least", "mean", "greatest");
  for (const auto& [name, range] : figures.at("results").items())
    text += fmt::format("  {:30}{:14.6g}{:14.6g}{:14.6g}\n", name, range.at("least").get<double>(),
                        range.at("mean").get<double>(), range.at("most").get<double>());
  fmt::print("{}", io::plain_text(text + folder.string() + ": worlds.csv, worlds.json\n", "\n"));
}

}  // namespace

int run_worlds(const RunOptions& options) {
  if (options.quiet) spdlog::set_level(spdlog::level::err);
  WorldsRun run(options);
  run.step(options.quiet);
  const nlohmann::ordered_json figures = run.write();
  if (options.json) {
    print_json(figures);
  } else if (!options.quiet) {
    print(figures, figures.at("folder").get<std::string>());
  }
  return run.interrupted() ? interrupted : success;
}

}  // namespace meniscus::cli
