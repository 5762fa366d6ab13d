// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Callbacks of C as functions of C++.
#pragma once

#include <meniscus/c/state.h>
#include <meniscus/snapshot.h>

#include <string>

struct MeniscusFileBytes {
  std::string bytes;
};

struct MeniscusLoopBody {
  const meniscus::LoopBody& body;
};

namespace meniscus::c {

// Each is empty for a null callback.
FileReader reader_of(MeniscusReadFile read, void* user);
LogSink sink_of(MeniscusLog log, void* user);
ParallelFor loop_of(MeniscusParallelFor loop, void* user);

/// Throws Error(invalid_argument) if its size or device is not valid.
LoadDef load_def_of(const MeniscusLoadDef* given);

}  // namespace meniscus::c
