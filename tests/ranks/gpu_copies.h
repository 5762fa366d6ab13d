// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Copies between a GPU and the host, for ranks that are threads and share one GPU.
#pragma once

#include <cstddef>

namespace meniscus::tests {

/// Both follow what is on `stream`, a cudaStream_t, and the host waits for them.
void copy_from_gpu(void* to, const void* from, std::size_t bytes, void* stream);
void copy_to_gpu(void* to, const void* from, std::size_t bytes, void* stream);

}  // namespace meniscus::tests
