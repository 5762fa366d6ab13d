// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Prints the state hash of each sample and of two dozen small scenes after a few frames. Run it before and
// after a change that must not move a bit, with the same compiler on the same machine, and compare the two
// outputs. state_hashes [--device cpu|cuda] [--threads N] [--frames N] [NAME...]
// The name `small` stands for all small scenes.
#include <meniscus/meniscus.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "sdk/scene/scene_file.h"
#include "tests/bench/small_scenes.h"

namespace {

using namespace meniscus;
using bench::small_scenes;
using bench::SmallScene;

struct Options {
  DeviceChoice device = DeviceChoice::cpu;
  int threads = 0;
  int frames = 0;  ///< 0: as many as the scene says
  std::vector<std::string> names;

  bool wants(const std::string& name) const {
    const auto given = [&](const std::string& n) {
      return std::find(names.begin(), names.end(), n) != names.end();
    };
    return names.empty() || given(name) || given(name.substr(0, name.find('/')));
  }
  int frames_or(int of_scene) const { return frames > 0 ? frames : of_scene; }
};

constexpr float frame = 0.016f;

void print(const std::string& name, const World& world) {
  std::printf("%-28s %016" PRIx64 "\n", name.c_str(), world.state_hash());
  std::fflush(stdout);
}

void run_small(const SmallScene& scene, const Options& options) {
  WorldDef def;
  def.device = options.device;
  def.threads = options.threads;
  scene.define(def);
  World world(def);
  scene.build(world);
  for (int k = options.frames_or(scene.frames); k > 0; --k) world.step(frame);
  print(scene.name, world);
}

/// Fewer frames where they are slow on the CPU.
int frames_for(const World& world) {
  return world.particle_count() > 200'000 ? 2 : world.particle_count() > 30'000 ? 8 : 30;
}

void run_sample(const std::filesystem::path& file, const Options& options) {
  Scene scene;
  try {
    scene = read_scene(file.string());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::io) throw;
    std::printf("%-28s skipped: %s\n", file.stem().c_str(), error.what());
    return;
  }
  scene.world.device = options.device;
  scene.world.threads = options.threads;
  BuiltScene built = build_scene(scene);
  for (int k = options.frames_or(frames_for(built.world)); k > 0; --k) built.world.step(scene.frame_time);
  print(file.stem().string(), built.world);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--device" && k + 1 < argc)
      options.device = std::strcmp(argv[++k], "cuda") == 0 ? DeviceChoice::cuda : DeviceChoice::cpu;
    else if (word == "--threads" && k + 1 < argc)
      options.threads = std::atoi(argv[++k]);
    else if (word == "--frames" && k + 1 < argc)
      options.frames = std::atoi(argv[++k]);
    else
      options.names.push_back(word);
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  for (const SmallScene& scene : small_scenes()) {
    if (options.wants(scene.name)) run_small(scene, options);
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(MENISCUS_SAMPLES_DIR "/scenes"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    if (options.wants(file.stem().string())) run_sample(file, options);
  }
}
