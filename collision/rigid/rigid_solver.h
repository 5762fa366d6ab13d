// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's solver, with an iteration of our own: sweeps alternate, so that a push travels through a stack
// both ways in two iterations and towers come to rest; and friction keeps to Coulomb's cone, where Bullet
// bounds two directions apart.
#pragma once

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

/// Needs SOLVER_USE_2_FRICTION_DIRECTIONS, and no rolling friction.
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
