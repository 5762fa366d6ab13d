// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

/// Marks what runs on both devices.
#ifdef __CUDACC__
#define MENISCUS_HD __host__ __device__
#else
#define MENISCUS_HD
#endif
