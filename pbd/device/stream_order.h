// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The order of work on two streams of a GPU.
#pragma once

namespace meniscus::pbd {

/// Work that `later` gets from now on starts after all that `earlier` has so far. The host does not wait.
/// Both are a cudaStream_t of the GPU with this ordinal. Throws Error(device).
void put_after(void* earlier, void* later, int ordinal);

}  // namespace meniscus::pbd
