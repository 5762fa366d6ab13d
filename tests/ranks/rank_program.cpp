// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// rank_program STEPS [OPTION...]: steps a broken dam on the ranks of mpirun, or alone, and prints its hash
// every ten steps. Options:
//
//   --cuda                 each rank has a GPU
//   --size WIDTH LENGTH    of the dam, in m
//   --height HEIGHT        of the dam, in m
//   --plain                without surface tension
//   --grid                 with the pressure grid
//   --flow                 with emitters, sinks and probes, which it prints too
//   --bodies               with bodies, of which it prints what they do
//   --drop                 instead, drops that meet without gravity; prints the relative error of momentum
//   --cuts slabs|pencils   where the cuts are; by default slabs
//   --move-cuts            by two layers with every step
//   --memory               each rank prints the memory of its device for each particle
//   --save FILE            saves the world after the steps
//   --at RANK CALL FAULT   at that call of its transport, or before it writes a file (CALL is `write`), that
//                          rank fails by FAULT: throw, exhaust (no more memory), kill or stop
#include <meniscus/error.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "sdk/ranks/launcher.h"
#include "sdk/ranks/mpi_ranks.h"
#include "sdk/world/shared/shared_world.h"
#include "tests/faults/failing_memory.h"
#include "tests/ranks/bodies.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/failing_ranks.h"
#include "tests/ranks/flow.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;  // s

struct Options {
  int steps = 0;
  float width = 0.3f, length = 1.3f, height = 0.8f;  // m
  bool pulls = true, gridded = false, flows = false, floats = false, drops = false, prints_memory = false,
       on_gpus = false;
  pbd::CutPolicy policy{.kind = pbd::CutKind::slabs};
  std::string file;
  struct {
    int rank = -1, call = 0;
    std::string kind;
  } fault;
};

World world_of(const Options& options) {
  const std::optional<int> gpu = options.on_gpus ? std::optional(process_of_host()) : std::nullopt;
  if (options.drops) return free_drops(options.floats);
  World world = broken_dam(options.width, options.length, options.pulls, gpu, options.flows || options.floats,
                           RigidSolver::bullet, options.gridded, options.height);
  if (options.flows) add_flow(world, options.width, options.length);
  if (options.floats) add_bodies(world, options.width, options.length);
  return world;
}

/// |P − P₀| over what one drop of both masses had.
double momentum_error(const World& world, Momentum before) {
  const Momentum now = momentum_of(world);
  const double x = now.x - before.x, y = now.y - before.y, z = now.z - before.z;
  return std::sqrt(x * x + y * y + z * z) / (now.mass * double{drop_speed});
}

void step_through(World& world, const Options& options) {
  const Momentum before = momentum_of(world);
  for (int k = 0; k < options.steps; ++k) {
    world.step(frame);
    if (k % 10 != 9) continue;
    std::printf("%016llx\n", static_cast<unsigned long long>(world.state_hash()));
    if (options.flows) std::printf("%s\n", told_by_flow(world).c_str());
    if (options.floats) std::printf("%s\n", told_by_bodies(world).c_str());
  }
  std::printf("particles %zu\n", world.positions().size());
  if (options.drops) std::printf("momentum %.3g\n", momentum_error(world, before));
  if (!options.file.empty()) world.save(options.file);
}

void print_memory(const World& world, std::size_t particles) {
  std::printf("memory %.1f bytes of each of %zu particles\n",
              static_cast<double>(world.device_bytes()) / static_cast<double>(particles), particles);
}

void share_and_step(pbd::Ranks& ranks, const Options& options) {
  World world = world_of(options);
  std::optional<FailingMemory> memory;
  const std::string& kind = options.fault.kind;
  FailingRanks failing(ranks, options.fault.rank == ranks.rank() ? options.fault.call : 0, [&] {
    if (kind == "kill") std::raise(SIGKILL);
    if (kind == "stop") std::raise(SIGSTOP);
    if (kind == "throw") throw Error(ErrorCode::device, "the test has cut the line");
    memory.emplace(FailureChoice{1, true});
  });
  SharedWorld shared(world, failing, options.policy);
  shared.leads() ? step_through(world, options) : static_cast<void>(shared.follow());
  if (options.prints_memory) print_memory(world, shared.own_particles());
}

void run_dam(const Options& options) {
  const std::unique_ptr<pbd::Ranks> ranks = join_mpi();
  if (ranks) return or_end_all(*ranks, [&] { share_and_step(*ranks, options); });
  World world = world_of(options);
  step_through(world, options);
  if (options.prints_memory) print_memory(world, world.positions().size());
}

Options options_of(int argc, char** argv) {
  Options options;
  if (argc > 1) options.steps = std::atoi(argv[1]);
  for (int k = 2; k < argc; ++k) {
    const std::string word = argv[k];
    const auto argument = [&](int n) { return std::string(k + n < argc ? argv[k + n] : ""); };
    if (word == "--cuda") options.on_gpus = true;
    if (word == "--plain") options.pulls = false;
    if (word == "--grid") options.gridded = true;
    if (word == "--flow") options.flows = true;
    if (word == "--bodies") options.floats = true;
    if (word == "--drop") options.drops = true;
    if (word == "--cuts" && argument(1) == "pencils") options.policy.kind = pbd::CutKind::pencils;
    if (word == "--move-cuts")
      options.policy = {.kind = options.policy.kind, .every = 1, .most_imbalance = 0, .shift = 2};
    if (word == "--memory") options.prints_memory = true;
    if (word == "--save") options.file = argument(1);
    if (word == "--height") options.height = std::strtof(argument(1).c_str(), nullptr);
    if (word == "--size") options.width = std::strtof(argument(1).c_str(), nullptr);
    if (word == "--size") options.length = std::strtof(argument(2).c_str(), nullptr);
    if (word != "--at") continue;
    const bool in_file = argument(2) == "write";
    options.fault = {std::atoi(argument(1).c_str()),
                     in_file ? FailingRanks::in_file : std::atoi(argument(2).c_str()), argument(3)};
  }
  return options;
}

}  // namespace
}  // namespace meniscus::tests

int main(int argc, char** argv) try {
  meniscus::tests::run_dam(meniscus::tests::options_of(argc, argv));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
