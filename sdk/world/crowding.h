// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How many particles may be created within one support radius.
#pragma once

#include <meniscus/types.h>

#include <cstdint>
#include <functional>
#include <span>

namespace meniscus {

/// `bound` is one on the particles within any support radius, and this keeps it. The present ones are read
/// only when the bound is too high to tell. Motion alone makes no crowd. Throws Error(capacity) if more than
/// world_tuning::most_crowded particles would be within `reach` (m) of one that is added. The message names
/// the call, how many, where, and the limit.
void check_crowding(uint64_t& bound, std::span<const Vec3> added,
                    const std::function<std::span<const Vec3>()>& present, float reach, const char* call);

}  // namespace meniscus
