// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions that run on the CPU and, where nvcc compiles them, on a GPU.
#pragma once

/// Stands before a function of a constraint: nvcc compiles it for both devices, other compilers for the CPU.
#ifdef __CUDACC__
#define MENISCUS_BOTH_DEVICES __host__ __device__
#else
#define MENISCUS_BOTH_DEVICES
#endif
