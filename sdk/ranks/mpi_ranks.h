// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ranks that are processes, joined by MPI.
#pragma once

#include <meniscus/error.h>

#include <memory>
#include <new>

#include "pbd/host_memory.h"
#include "pbd/ranks/ranks.h"

namespace meniscus {

/// The ranks that a launcher such as mpirun has started, or none if it has started one process or nothing
/// did. Throws Error(invalid_argument) if it has started several and this build has no MPI. Call it once. If
/// an exception destroys the result, the processes of all ranks end.
///
/// A rank that does not arrive where others wait for it ends all of them, with its number: after the time
/// limit that MENISCUS_RANK_LIMIT in the environment gives in seconds, by default 20; 0: without a limit.
std::unique_ptr<pbd::Ranks> join_mpi();

/// Runs work of this rank. If it throws, all ranks end, and the message says why.
template <class Work>
decltype(auto) or_end_all(pbd::Ranks& ranks, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    ranks.fail(pbd::no_host_memory.what());
    throw;
  } catch (const std::exception& error) {
    ranks.fail(error.what());
    throw;
  }
}

}  // namespace meniscus
