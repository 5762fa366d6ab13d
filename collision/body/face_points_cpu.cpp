// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FacePoints for the CPU.
#include "collision/body/face_points.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::FacePoints<meniscus::pbd::CpuDevice>;
