// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ranks that are processes, joined by MPI.
#pragma once

#include <memory>

#include "pbd/ranks/ranks.h"

namespace meniscus {

/// The ranks that a launcher such as mpirun has started, or none if it has started one process or nothing
/// did. Throws Error(invalid_argument) if it has started several and this build has no MPI. Call it once. If
/// an exception destroys the result, the processes of all ranks end.
std::unique_ptr<pbd::Ranks> join_mpi();

}  // namespace meniscus
