// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps, one line of JSON a case.
//   bench dam --device cuda --particles 100000,1000000 --iterations 4 --out FILE
//   bench dam --device cuda --particles 100000 --iterations 4 --boxes 1000 --out FILE
//   bench dam --device cpu --particles 100000 --substeps 4 --iterations 30 --tolerance 0.0005
//   mpirun -n 2 bench dam --device cuda --particles 16000000 --fixed-sums
//   bench pool --device cuda --particles 1000000 --layers 100 --solver grid --out FILE
//   bench hanging --n 250 --substeps 20 --iterations 1 --no-tethers --seconds 10
//   bench drape --n 250,500
//   bench sheet --fabric-density 0.2,40 --substeps 4 --iterations 2
//   bench surface --particles 1000000
//   bench batch --device cuda --worlds 256,1024,4096 --particles 1000 --reset 0.01
//   bench snapshot --device cuda --particles 1000000
//   bench render --device cuda --particles 100000,1000000
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "sdk/ranks/mpi_ranks.h"
#include "tests/bench/batch.h"
#include "tests/bench/cloth.h"
#include "tests/bench/dam.h"
#include "tests/bench/pool.h"
#include "tests/bench/sheet.h"
#include "tests/bench/snapshot.h"
#ifdef MENISCUS_WITH_RENDERER
#include "tests/bench/render.h"
#endif
#include "tests/bench/surface.h"

int main(int argc, char** argv) {
  using namespace meniscus::bench;
  CommonOptions common;
  DamOptions dam;
  PoolOptions pool;
  ClothOptions hanging, drape;
  SheetOptions sheet;
  SurfaceOptions surface;
  BatchOptions batch;
  SnapshotOptions snapshot;
  CLI::App app("Times steps, and says what they were worth");
  app.fallthrough();
  app.require_subcommand(1);
  app.add_option("--device", common.device)->check(CLI::IsMember({"auto", "cpu", "cuda"}));
  app.add_option("--threads", common.threads, "of the CPU; 0: one a core");
  app.add_option("--commit", common.commit, "noted in the results");
  app.add_option("--date", common.date, "noted in the results");
  app.add_option("--out", common.out, "write the results here as well");
  const CLI::App* dam_case = add_dam(app, dam);
  const CLI::App* pool_case = add_pool(app, pool);
  const CLI::App* hanging_case = add_hanging(app, hanging);
  const CLI::App* drape_case = add_drape(app, drape);
  const CLI::App* sheet_case = add_sheet(app, sheet);
  const CLI::App* surface_case = add_surface(app, surface);
  const CLI::App* batch_case = add_batch(app, batch);
  const CLI::App* snapshot_case = add_snapshot(app, snapshot);
#ifdef MENISCUS_WITH_RENDERER
  RenderOptions render;
  const CLI::App* render_case = add_render(app, render);
#endif
  CLI11_PARSE(app, argc, argv);
  try {
    const std::unique_ptr<meniscus::pbd::Ranks> ranks = meniscus::join_mpi();
    common.ranks = ranks.get();
    if (ranks && !dam_case->parsed()) throw std::invalid_argument("dam is the case of several ranks");
    Results results(common, argc, argv);
    if (dam_case->parsed()) run_dam(common, dam, results);
    if (pool_case->parsed()) run_pool(common, pool, results);
    if (hanging_case->parsed()) run_hanging(common, hanging, results);
    if (drape_case->parsed()) run_drape(common, drape, results);
    if (sheet_case->parsed()) run_sheet(common, sheet, results);
    if (surface_case->parsed()) run_surface(common, surface, results);
    if (batch_case->parsed()) run_batch(common, batch, results);
    if (snapshot_case->parsed()) run_snapshot(common, snapshot, results);
#ifdef MENISCUS_WITH_RENDERER
    if (render_case->parsed()) run_render(common, render, results);
#endif
    results.write();
  } catch (const std::exception& error) {
    std::cerr << "bench: " << error.what() << "\n";
    return 1;
  }
}
