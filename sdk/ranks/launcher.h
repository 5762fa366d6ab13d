// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a launcher of MPI says in the environment of the processes that it starts.
#pragma once

#include <cstdlib>

namespace meniscus {

/// The number of processes that a launcher has started together; 1 without one.
inline int launched_processes() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"}) {
    if (const char* size = std::getenv(name)) return std::atoi(size);
  }
  return 1;
}

/// The number of this process among those that a launcher has started on this host; 0 without one.
inline int process_of_host() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_RANK", "MPI_LOCALRANKID", "MV2_COMM_WORLD_LOCAL_RANK"}) {
    if (const char* number = std::getenv(name)) return std::atoi(number);
  }
  return 0;
}

}  // namespace meniscus
