// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid worlds with either solver of contacts, for tests that hold for both.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

enum class Solver { bullet, device };

inline constexpr Solver solvers[] = {Solver::bullet, Solver::device};

inline void PrintTo(Solver solver, std::ostream* out) {
  *out << (solver == Solver::bullet ? "bullet" : "device");
}

struct SolverDevice {
  pbd::CpuDevice device{1};
  RigidContactSet<pbd::CpuDevice> contact_set{device};
};

class SolverWorld : private SolverDevice, public RigidWorld {
 public:
  explicit SolverWorld(Solver solver, const RigidWorldDef& def = {}) : RigidWorld(with(def, solver)) {
    if (solver == Solver::device) set_contacts(&contact_set);
  }

 private:
  static RigidWorldDef with(RigidWorldDef def, Solver solver) {
    def.on_device = solver == Solver::device;
    return def;
  }
};

/// A suite that is declared as a class derived from this runs with each solver.
class OnSolver : public testing::TestWithParam<Solver> {};

inline std::string solver_test_name(const testing::TestParamInfo<Solver>& info) {
  return testing::PrintToString(info.param);
}

}  // namespace meniscus::collision

#define MENISCUS_WITH_EACH_SOLVER(suite)                                                 \
  INSTANTIATE_TEST_SUITE_P(With, suite, testing::ValuesIn(meniscus::collision::solvers), \
                           meniscus::collision::solver_test_name)
