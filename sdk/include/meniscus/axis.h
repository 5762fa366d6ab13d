// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The axes of a frame.
#pragma once

namespace meniscus {

/// An axis of a frame.
enum class Axis { x, y, z };

}  // namespace meniscus
