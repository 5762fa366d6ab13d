// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// rank_program STEPS [--move-cuts] [--size WIDTH LENGTH] [--memory] [--at RANK CALL throw|exhaust|kill]: steps
// a broken dam of that size (m) on the ranks of mpirun, or alone, and prints its hash every ten steps. Each
// rank may also print the memory of its device. At that call of its transport, that rank throws, has no more
// memory, or is killed.
#include <meniscus/error.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "sdk/ranks/mpi_ranks.h"
#include "sdk/world/shared/shared_world.h"
#include "tests/faults/failing_memory.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/failing_ranks.h"

namespace meniscus::tests {
namespace {

struct Fault {
  int rank = -1, call = 0;
  std::string kind;
};

void step_through(World& world, int steps) {
  for (int k = 0; k < steps; ++k) {
    world.step(0.008f);
    if (k % 10 == 9) std::printf("%016llx\n", static_cast<unsigned long long>(world.state_hash()));
  }
  std::printf("particles %zu\n", world.positions().size());
}

void print_memory(const World& world, std::size_t particles) {
  std::printf("memory %.1f bytes of each of %zu particles\n",
              static_cast<double>(world.device_bytes()) / static_cast<double>(particles), particles);
}

struct Options {
  int steps = 0;
  float width = 0.3f, length = 1.3f;  // m
  bool prints_memory = false;
  pbd::CutPolicy policy;
  Fault fault;
};

void share_and_step(const Options& options) {
  const std::unique_ptr<pbd::Ranks> ranks = join_mpi();
  const Fault& fault = options.fault;
  World world = broken_dam(options.width, options.length);
  if (!ranks) {
    step_through(world, options.steps);
    if (options.prints_memory) print_memory(world, world.positions().size());
    return;
  }
  std::optional<FailingMemory> memory;
  FailingRanks failing(*ranks, fault.rank == ranks->rank() ? fault.call : 0, [&] {
    if (fault.kind == "kill") std::raise(SIGKILL);
    if (fault.kind == "throw") throw Error(ErrorCode::device, "the test has cut the line");
    memory.emplace(FailureChoice{1, true});
  });
  SharedWorld shared(world, failing, options.policy);
  shared.leads() ? step_through(world, options.steps) : shared.follow();
  if (options.prints_memory) print_memory(world, shared.own_particles());
}

Options options_of(int argc, char** argv) {
  Options options;
  if (argc > 1) options.steps = std::atoi(argv[1]);
  for (int k = 2; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--move-cuts") options.policy = {.every = 1, .most_imbalance = 0, .shift = 2};
    if (word == "--memory") options.prints_memory = true;
    if (word == "--size" && k + 2 < argc) {
      options.width = std::strtof(argv[k + 1], nullptr);
      options.length = std::strtof(argv[k + 2], nullptr);
    }
    if (word == "--at" && k + 3 < argc)
      options.fault = {std::atoi(argv[k + 1]), std::atoi(argv[k + 2]), argv[k + 3]};
  }
  return options;
}

}  // namespace
}  // namespace meniscus::tests

int main(int argc, char** argv) try {
  meniscus::tests::share_and_step(meniscus::tests::options_of(argc, argv));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
