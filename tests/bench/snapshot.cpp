// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of snapshots on the device.
#include "tests/bench/snapshot.h"

#include <chrono>
#include <stdexcept>

#include "tests/bench/dam.h"

namespace meniscus::bench {

namespace {

/// Milliseconds a call, of `count` calls and of the work on the device that they start.
template <class Call>
double ms_each(const World& world, int count, const Call& call) {
  world.diagnostics();  // waits for the device
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < count; ++k) call();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / count;
}

Json run_case(const CommonOptions& common, const SnapshotOptions& o, int particles) {
  Dam dam(common, {}, particles, 4);
  World& world = dam.world;
  for (int k = 0; k < 20; ++k) world.step(dam.dt);
  const Snapshot first = world.snapshot();
  const uint64_t hash = world.state_hash();
  for (int k = 0; k < 5; ++k) world.step(dam.dt);
  const double snapshot_ms = ms_each(world, o.repeats, [&] { world.snapshot(); });
  // A restore waits for what was started before, and so for the restore before it.
  const double restore_ms = ms_each(world, o.repeats, [&] { world.restore(first); });
  if (world.state_hash() != hash) throw std::runtime_error("a restored world has another hash");
  return {{"particles", world.particle_count()},
          {"repeats", o.repeats},
          {"snapshot_ms", snapshot_ms},
          {"restore_ms", restore_ms}};
}

}  // namespace

CLI::App* add_snapshot(CLI::App& app, SnapshotOptions& o) {
  CLI::App* snapshot = app.add_subcommand("snapshot", "snapshots of a dam break, and going back to them");
  snapshot->add_option("--particles", o.particles, "how many, one case each")->delimiter(',');
  snapshot->add_option("--repeats", o.repeats, "of each call")->check(CLI::Range(1, 10000));
  return snapshot;
}

void run_snapshot(const CommonOptions& common, const SnapshotOptions& options, Results& results) {
  for (int particles : options.particles) results.add(run_case(common, options, particles));
}

}  // namespace meniscus::bench
