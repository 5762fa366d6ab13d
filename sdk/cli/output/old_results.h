// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace meniscus::cli {

/// Takes what an earlier run has written out of its folder, and nothing else: a shorter run, or one of
/// another scene, would leave some of it among its own. What cannot be removed stays.
void remove_old_results(const std::filesystem::path& folder);

}  // namespace meniscus::cli
