// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds on each device with each solver of contacts among solids, for tests that hold for both solvers.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/worlds.h"

namespace meniscus::tests {

struct SolverCase {
  pbd::DeviceKind device;
  RigidSolver solver;

  friend void PrintTo(const SolverCase& c, std::ostream* out) {
    *out << testing::PrintToString(c.device) << (c.solver == RigidSolver::device ? "_device" : "_bullet");
  }
};

inline std::vector<SolverCase> solver_cases() {
  std::vector<SolverCase> cases;
  for (const pbd::DeviceKind device : usable_devices())
    for (const RigidSolver solver : {RigidSolver::bullet, RigidSolver::device})
      cases.push_back({device, solver});
  return cases;
}

inline WorldDef world_def(const SolverCase& c, float spacing) {
  WorldDef def = world_def(c.device, spacing);
  def.rigid.solver = c.solver;
  return def;
}

/// A suite that is declared as a class derived from this runs on each usable device with each solver.
class WithSolver : public testing::TestWithParam<SolverCase> {};

inline std::string solver_case_name(const testing::TestParamInfo<SolverCase>& info) {
  return testing::PrintToString(info.param);
}

}  // namespace meniscus::tests

#define MENISCUS_WITH_EACH_RIGID_SOLVER(suite)                                            \
  INSTANTIATE_TEST_SUITE_P(On, suite, testing::ValuesIn(meniscus::tests::solver_cases()), \
                           meniscus::tests::solver_case_name)
