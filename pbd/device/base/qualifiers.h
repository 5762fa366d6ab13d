// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Macros for code that is compiled for both devices, and for the unrolling of loops.
#pragma once

/// Marks functions that run on both devices.
#ifdef __CUDACC__
#define MENISCUS_HD __host__ __device__
#else
#define MENISCUS_HD
#endif

/// Placed before a loop of at most eight iterations: the first unrolls it, so that expressions in its counter
/// are constants; the second keeps it a loop. In nvcc's host pass neither compiler knows the other's pragma.
#if defined(__CUDA_ARCH__)
#define MENISCUS_UNROLL _Pragma("unroll")
#define MENISCUS_NO_UNROLL _Pragma("unroll 1")
#elif defined(__CUDACC__)
#define MENISCUS_UNROLL
#define MENISCUS_NO_UNROLL
#else
#define MENISCUS_UNROLL _Pragma("GCC unroll 8")
#define MENISCUS_NO_UNROLL _Pragma("GCC unroll 1")
#endif
