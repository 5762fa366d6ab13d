// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The look of the panels.
#pragma once

namespace meniscus::viewer {

/// Sets the look of the panels, for a screen with `scale` pixels per unit length.
void set_style(float scale);

}  // namespace meniscus::viewer
