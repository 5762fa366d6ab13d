// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus run`: steps a scene and writes its frames, pictures and figures.
#include "sdk/cli/commands/run.h"

#include <meniscus/error.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/commands/progress.h"
#include "sdk/cli/commands/resume.h"
#include "sdk/cli/commands/run_files.h"
#include "sdk/cli/commands/scene_warnings.h"
#include "sdk/cli/output/folder_lock.h"
#include "sdk/cli/output/frame_exporter.h"
#include "sdk/cli/output/frame_pictures.h"
#include "sdk/cli/output/old_results.h"
#include "sdk/cli/output/rank_frames.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/cli/record/run_recorder.h"
#include "sdk/cli/record/run_summary.h"
#include "sdk/cli/record/scene_checks.h"
#include "sdk/cli/stop/interrupt.h"
#include "sdk/fields/probes.h"
#include "sdk/io/abc/abc_recording.h"
#include "sdk/io/plain_text.h"
#include "sdk/io/vdb.h"
#include "sdk/ranks/launcher.h"
#include "sdk/ranks/mpi_ranks.h"
#include "sdk/scene/build_scene.h"
#include "sdk/world/shared/shared_world.h"

namespace meniscus::cli {
namespace {

bool exports(const RunOptions& options, const char* format) {
  return std::count(options.formats.begin(), options.formats.end(), format) > 0;
}

Scene scene_of(const RunOptions& options) {
  expect_files_apart(options);
  if (exports(options, "vdb")) io::require_vdb();
  if (exports(options, "abc")) io::require_abc();
  Scene scene = chosen_scene(options.scene);
  if (options.frames) scene.frames = *options.frames;
  expect_floor(scene);
  return scene;
}

const std::filesystem::path& made(const std::filesystem::path& folder) {
  make_folder(folder);
  return folder;
}

/// Makes the folder ready, and starts the recording of the world.
const std::filesystem::path& cleared(const std::filesystem::path& folder, const RunOptions& options,
                                     World& world) {
  if (!options.formats.empty()) make_frames_folder(folder);
  if (!options.record.empty()) world.start_recording(options.record);
  remove_old_results(folder);  // after everything that may fail: a run that cannot start changes nothing
  return folder;
}

/// The ranks of a host have its GPUs in turn, unless the scene names one.
Scene with_own_gpu(Scene scene) {
  const bool may_be_gpu = scene.world.device != DeviceChoice::cpu && list_devices().front().usable;
  if (may_be_gpu && !scene.world.cuda_device) scene.world.cuda_device = process_of_host();
  return scene;
}

BuiltScene built_of(const RunOptions& options, const Scene& given, bool is_shared) {
  if (is_shared && !options.record.empty())
    throw Error(ErrorCode::invalid_argument, "--record needs a run on one rank");
  const Scene scene = is_shared ? with_own_gpu(given) : given;
  BuiltScene built = !options.from.empty() ? resume_scene(scene, options.from)
                     : is_shared           ? build_scene(scene, SharedWorld::hold_back)
                                           : build_scene(scene);
  if (is_shared) SharedWorld::check(built.world);
  if (options.from.empty()) return built;
  const int reached = frame_of(built.world, scene);
  if (reached < scene.frames) return built;
  throw Error(ErrorCode::invalid_argument, options.from + " is of frame " + std::to_string(reached) +
                                               ", and the run ends with frame " +
                                               std::to_string(scene.frames) + "; --frames takes a later one");
}

pbd::CutPolicy cuts_of(const RunOptions& options) {
  pbd::CutPolicy policy;
  if (options.cuts == "slabs") policy.kind = pbd::CutKind::slabs;
  if (options.cuts == "pencils") policy.kind = pbd::CutKind::pencils;
  return policy;
}

class Run {
 public:
  /// `ranks`: those that share the world, of which this is the first; none where it is alone.
  Run(const RunOptions& options, pbd::Ranks* ranks)
      : ranks_(ranks),
        scene_(scene_of(options)),
        picture_(picture_scene(scene_, options.picture)),
        liquid_(options.surface || exports(options, "vdb")),
        has_texture_(!options.formats.empty() || options.picture.any()),
        writes_pieces_(ranks && exports(options, "vtp")),
        folder_(results_folder(options, scene_)),
        built_(built_of(options, scene_, ranks != nullptr)),
        shared_(ranks ? std::make_unique<SharedWorld>(built_.world, *ranks, cuts_of(options)) : nullptr),
        reached_(frame_of(built_.world, scene_)),
        save_every_(options.save_every),
        records_(!options.record.empty()),
        rope_mass_(mass_of_ropes()),
        first_(sample(reached_, {})),
        pictures_(options.picture, folder_, picture_, scene_, built_.world, first_),
        lock_(made(folder_)),
        exporter_(cleared(folder_, options, built_.world), options.formats, options.surface, scene_,
                  ranks ? ranks->count() : 0),
        recorder_(folder_, scene_) {
    warn_of_oddities(scene_, built_);
  }

  /// From here on an error ends the run but not the program: the results so far are still written.
  void step_through(bool quiet) {
    const Interrupt interrupt(built_.world);
    Progress progress(scene_.frames, quiet);
    recorder_.start(built_.world.device(), first_, masses());
    note_error([&] {
      write(first_);
      for (int frame = reached_ + 1; frame <= scene_.frames && !interrupt.raised(); ++frame) {
        FrameSample now = sample(frame, built_.world.step(scene_.frame_time));
        recorder_.add(now);
        write(now);
        pictures_.add(built_.world, now);
        if (save_every_ && frame % *save_every_ == 0)
          built_.world.save(snapshot_path(folder_, frame).string());
        progress.show(
            frame, now.step.ms,
            scene_.fluids.empty() ? std::nullopt : std::optional(now.diagnostics.density_error_mean));
      }
    });
    note_error([&] {
      if (records_) built_.world.stop_recording();
    });
    note_error([&] { exporter_.finish(); });
    end_.interrupted = interrupt.raised();
  }

  nlohmann::ordered_json write_results() {
    end_.state_hash = built_.world.state_hash();
    end_.device_bytes = built_.world.device_bytes();
    nlohmann::ordered_json figures = recorder_.finish(end_);
    pictures_.finish(built_.world, sample(0, {}));
    return figures;
  }

  const RunEnd& end() const { return end_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::vector<std::string> pictures() const { return pictures_.files(); }

 private:
  /// Notes the first error of the run. A cancelled call is none.
  template <class Call>
  void note_error(const Call& call) {
    std::string message;
    try {
      call();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::cancelled) message = error.what();
    } catch (const std::exception& error) {
      message = error.what();
    }
    if (end_.error.empty()) end_.error = message;
  }

  /// The geometry of a frame; that of frame 0 is the state before the first step.
  void write(FrameSample& now) {
    if (liquid_) now.liquid = io::liquid_frame_of(built_.world, built_.fluids, scene_.fluids);
    if (writes_pieces_) write_pieces(*shared_, *ranks_, folder_, now.frame, now.particles.time);
    exporter_.write(now);
  }

  FrameSample sample(int frame, const StepReport& step) const {
    const World& world = built_.world;
    FrameSample now{.frame = frame,
                    .step = step,
                    .diagnostics = world.diagnostics(),
                    .mass = 0,
                    .particles = io::frame_of(world),
                    .diffuse = {world.time(), world.diffuse()},
                    .emitted = {},
                    .taken = {},
                    .probes = {},
                    .probe_vectors = {},
                    .bodies = states(),
                    .cloth = io::cloth_frame_of(world, built_.cloths, scene_.cloths),
                    .ropes = io::rope_frame_of(world, built_.ropes, scene_.ropes),
                    .liquid = {},
                    .cloths = {},
                    .welded = {},
                    .bending = {},
                    .tears = tears(),
                    .attachment_forces = {}};
    if (has_texture_) io::add_texture(now.cloth, world, built_.cloths);
    std::vector<std::size_t> counts(built_.fluids.size());
    for (const uint32_t fluid : now.particles.fluids) ++counts.at(fluid);
    for (const FluidId fluid : built_.fluids) {
      now.mass += static_cast<double>(counts.at(fluid.index)) * world.particle_mass(fluid);
    }
    for (const EmitterId emitter : built_.emitters) now.emitted.push_back(world.emitter_count(emitter).total);
    for (const SinkId sink : built_.sinks) now.taken.push_back(world.sink_count(sink).total);
    for (std::size_t i = 0; i < built_.probes.size(); ++i) {
      const ProbeId probe = built_.probes[i];
      now.probes.push_back(world.probe(probe));
      const bool has_vector = is_vector(scene_.probes[i].def.kind);
      now.probe_vectors.push_back(has_vector ? std::optional(world.probe_vector(probe)) : std::nullopt);
    }
    for (const ClothId cloth : built_.cloths) {
      now.cloths.push_back(world.cloth_state(cloth));
      now.welded.push_back(world.cloth_welded_vertices(cloth));
      now.bending.push_back(world.cloth_bending_fraction(cloth));
      now.mass += double{now.cloths.back().mass};
    }
    now.mass += rope_mass_;
    for (const AttachmentId attachment : built_.attachments)
      now.attachment_forces.push_back(world.attachment_force(attachment));
    return now;
  }

  /// kg, of all ropes at the start.
  double mass_of_ropes() const {
    const std::vector<double> lengths = io::rope_frame_of(built_.world, built_.ropes, scene_.ropes).lengths();
    double mass = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const RopeDef& rope = scene_.ropes[i];
      mass += double{rope.density} * std::numbers::pi * rope.radius * rope.radius * lengths[i];
    }
    return mass;
  }

  /// Tears of each piece of cloth in the last step.
  std::vector<std::size_t> tears() const {
    std::vector<std::size_t> tears;
    const std::vector<TearEvent>& events = built_.world.tear_events();
    for (const ClothId cloth : built_.cloths) {
      const auto is_its = [&](const TearEvent& event) { return event.cloth == cloth; };
      tears.push_back(static_cast<std::size_t>(std::count_if(events.begin(), events.end(), is_its)));
    }
    return tears;
  }

  std::vector<BodyState> states() const {
    std::vector<BodyState> states;
    for (const BodyId body : built_.bodies) states.push_back(built_.world.body_state(body));
    return states;
  }

  std::vector<BodyMass> masses() const {
    std::vector<BodyMass> masses;
    for (const BodyId body : built_.bodies) masses.push_back(built_.world.body_mass(body));
    return masses;
  }

  pbd::Ranks* ranks_;
  Scene scene_;
  io::PreviewScene picture_;
  bool liquid_;         // whether surfaces of fluids are exported, as meshes or as volumes
  bool has_texture_;    // whether samples have the texture of cloth
  bool writes_pieces_;  // whether each rank writes its own particles
  std::filesystem::path folder_;
  BuiltScene built_;
  std::unique_ptr<SharedWorld> shared_;  // with ranks, from here on until it has stepped
  int reached_;                          // the frame from which it starts; 0 without a snapshot
  std::optional<int> save_every_;
  bool records_;  // whether the world is recorded
  double rope_mass_;
  FrameSample first_;       // the state before the first frame
  FramePictures pictures_;  // made before the folder: a run that cannot start leaves it as it was
  FolderLock lock_;         // before the first file of the run
  FrameExporter exporter_;  // first removes the files of the run before
  RunRecorder recorder_;
  RunEnd end_;
};

/// What a rank does that is not the first.
int follow(const RunOptions& options, pbd::Ranks& ranks) {
  const Scene scene = scene_of(options);
  BuiltScene built = built_of(options, scene, true);
  SharedWorld shared(built.world, ranks, cuts_of(options));
  follow_and_write(shared, ranks, results_folder(options, scene));
  return success;
}

void print_results(const nlohmann::ordered_json& figures, const Run& run, const RunOptions& options) {
  if (options.json) {
    nlohmann::ordered_json results = figures;
    results["folder"] = run.folder().string();
    print_json(results);
  } else if (!options.quiet) {
    fmt::print("{}", io::plain_text(
                         run_summary(figures, run.folder(), options.formats, run.pictures(), options.surface),
                         "\n"));
  }
}

/// Reports the checks that failed; returns whether any did.
bool report_broken(const nlohmann::ordered_json& figures) {
  bool any = false;
  for (const auto& check : figures.at("checks")) {
    if (check.at("state").get_ref<const std::string&>() != "broken") continue;
    spdlog::error("the check {}", check_line(check));
    any = true;
  }
  return any;
}

/// What the first rank does, or the only one.
int run_alone_or_first(const RunOptions& options, pbd::Ranks* ranks) {
  Run run(options, ranks);
  run.step_through(options.quiet);
  if (!run.end().error.empty())
    spdlog::error("{}", run.end().error);  // first, as it may cause the failures below
  bool broken = false;
  try {
    const nlohmann::ordered_json figures = run.write_results();
    print_results(figures, run, options);
    broken = report_broken(figures);
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return run_failed;
  }
  if (!run.end().error.empty()) return run_failed;
  if (run.end().interrupted) return interrupted;
  return broken ? check_broken : success;
}

}  // namespace

int run_scene(const RunOptions& options) {
  if (options.quiet) spdlog::set_level(spdlog::level::err);
  const std::unique_ptr<pbd::Ranks> ranks = join_mpi();
  if (!ranks) return run_alone_or_first(options, nullptr);
  return or_end_all(*ranks, [&] {
    return ranks->rank() > 0 ? follow(options, *ranks) : run_alone_or_first(options, ranks.get());
  });
}

}  // namespace meniscus::cli
