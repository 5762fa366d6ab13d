// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

namespace meniscus::viewer {

/// How panels look, for a screen with so many pixels a length of one.
void set_style(float scale);

}  // namespace meniscus::viewer
