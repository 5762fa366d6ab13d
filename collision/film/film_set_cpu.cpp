// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FilmSet for the CPU.
#include "collision/film/film_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::FilmSet<meniscus::pbd::CpuDevice>;
