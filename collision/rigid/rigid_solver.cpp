// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of RigidSolver.
#include "collision/rigid/rigid_solver.h"

#include <algorithm>
#include <cmath>

namespace meniscus::collision {

namespace {

/// Calls for all rows, in reverse order in every second iteration; returns the largest result.
template <class Call>
float sweep(const btConstraintArray& rows, int iteration, const Call& call) {
  float most = 0;
  for (int i = 0; i < rows.size(); ++i) {
    most = std::max(most, std::fabs(call(rows[iteration % 2 == 0 ? i : rows.size() - 1 - i])));
  }
  return most;
}

}  // namespace

float RigidSolver::solve_joint(const btSolverConstraint& joint, int iteration) {
  if (iteration >= joint.m_overrideNumSolverIterations) return 0;
  return resolveSingleConstraintRowGeneric(m_tmpSolverBodyPool[joint.m_solverBodyIdA],
                                           m_tmpSolverBodyPool[joint.m_solverBodyIdB],
                                           const_cast<btSolverConstraint&>(joint));
}

float RigidSolver::solve_contact(const btSolverConstraint& contact) {
  return resolveSingleConstraintRowLowerLimit(m_tmpSolverBodyPool[contact.m_solverBodyIdA],
                                              m_tmpSolverBodyPool[contact.m_solverBodyIdB],
                                              const_cast<btSolverConstraint&>(contact));
}

float RigidSolver::solve_within(btSolverConstraint& friction, float limit) {
  friction.m_lowerLimit = -limit;
  friction.m_upperLimit = limit;
  return resolveSingleConstraintRowGeneric(m_tmpSolverBodyPool[friction.m_solverBodyIdA],
                                           m_tmpSolverBodyPool[friction.m_solverBodyIdB], friction);
}

/// Each direction gets what the other one leaves of the cone.
float RigidSolver::solve_friction(const btSolverConstraint& contact) {
  btSolverConstraint& along = m_tmpSolverContactFrictionConstraintPool[contact.m_frictionIndex];
  btSolverConstraint& across = m_tmpSolverContactFrictionConstraintPool[contact.m_frictionIndex + 1];
  const float cone = along.m_friction * std::max(0.0f, float{contact.m_appliedImpulse});
  const auto rest = [cone](float other) { return std::sqrt(std::max(0.0f, cone * cone - other * other)); };
  const float first = solve_within(along, rest(across.m_appliedImpulse));
  return std::max(std::fabs(first), std::fabs(solve_within(across, rest(along.m_appliedImpulse))));
}

btScalar RigidSolver::solveSingleIteration(int iteration, btCollisionObject**, int, btPersistentManifold**,
                                           int, btTypedConstraint**, int, const btContactSolverInfo&,
                                           btIDebugDraw*) {
  using Row = const btSolverConstraint&;
  const float joints = sweep(m_tmpSolverNonContactConstraintPool, iteration,
                             [&](Row joint) { return solve_joint(joint, iteration); });
  const float contacts =
      sweep(m_tmpSolverContactConstraintPool, iteration, [&](Row c) { return solve_contact(c); });
  const float friction =
      sweep(m_tmpSolverContactConstraintPool, iteration, [&](Row c) { return solve_friction(c); });
  const float residual = std::max({joints, contacts, friction});
  return residual * residual;
}

}  // namespace meniscus::collision
