// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stands in for MPI where it was not there at build time.
#include <meniscus/error.h>

#include <string>

#include "sdk/ranks/launcher.h"
#include "sdk/ranks/mpi_ranks.h"

namespace meniscus {

std::unique_ptr<pbd::Ranks> join_mpi() {
  const int processes = launched_processes();
  if (processes <= 1) return nullptr;
  throw Error(ErrorCode::invalid_argument,
              "a launcher has started " + std::to_string(processes) +
                  " processes, but this program has no MPI: " + MENISCUS_NO_MPI_REASON);
}

}  // namespace meniscus
