// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// rank_program STEPS [--cuda] [--move-cuts] [--at RANK CALL throw|exhaust|kill]: steps a broken dam on the
// ranks of mpirun, or alone, and prints its hash every ten steps. At that call of its transport, that rank
// throws, has no more memory, or is killed. With --cuda each rank has a GPU.
#include <meniscus/error.h>

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

void share_and_step(int steps, bool on_gpus, const pbd::CutPolicy& policy, const Fault& fault) {
  const std::unique_ptr<pbd::Ranks> ranks = join_mpi();
  World world = broken_dam(0.3f, on_gpus ? std::optional(process_of_host()) : std::nullopt);
  if (!ranks) return step_through(world, steps);
  std::optional<FailingMemory> memory;
  FailingRanks failing(*ranks, fault.rank == ranks->rank() ? fault.call : 0, [&] {
    if (fault.kind == "kill") std::raise(SIGKILL);
    if (fault.kind == "throw") throw Error(ErrorCode::device, "the test has cut the line");
    memory.emplace(FailureChoice{1, true});
  });
  SharedWorld shared(world, failing, policy);
  shared.leads() ? step_through(world, steps) : shared.follow();
}

}  // namespace
}  // namespace meniscus::tests

int main(int argc, char** argv) try {
  meniscus::pbd::CutPolicy policy;
  meniscus::tests::Fault fault;
  bool on_gpus = false;
  for (int k = 2; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--cuda") on_gpus = true;
    if (word == "--move-cuts") policy = {.every = 1, .most_imbalance = 0, .shift = 2};
    if (word == "--at" && k + 3 < argc) fault = {std::atoi(argv[k + 1]), std::atoi(argv[k + 2]), argv[k + 3]};
  }
  meniscus::tests::share_and_step(argc > 1 ? std::atoi(argv[1]) : 0, on_gpus, policy, fault);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
