// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's solver, with our own iteration. Sweeps alternate in direction, so a push propagates through a
// stack both ways in two iterations, and towers come to rest. Friction is bounded by Coulomb's cone, where
// Bullet bounds two directions separately.
#pragma once

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

/// Needs SOLVER_USE_2_FRICTION_DIRECTIONS. There must be no rolling friction.
class RigidSolver final : public btSequentialImpulseConstraintSolver {
 protected:
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count,
                                btTypedConstraint** joints, int joint_count, const btContactSolverInfo& info,
                                btIDebugDraw* drawer) override;

 private:
  float solve_joint(const btSolverConstraint& joint, int iteration);
  float solve_contact(const btSolverConstraint& contact);
  float solve_friction(const btSolverConstraint& contact);
  float solve_within(btSolverConstraint& friction, float limit);
};

}  // namespace meniscus::collision
