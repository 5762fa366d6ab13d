// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Removal of the files that an earlier run left in the output folder.
#pragma once

#include <filesystem>

namespace meniscus::cli {

/// Removes the files that an earlier run has written to its folder, and nothing else. Otherwise a shorter
/// run, or one of another scene, would leave some of them among its own. Files that cannot be removed stay.
void remove_old_results(const std::filesystem::path& folder);

/// Whether a run in the folder gives a file of its own this path. Both are resolved.
bool is_result(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace meniscus::cli
