// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The figures of a run in words, for the terminal.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace meniscus::cli {

/// The figures of summary.json in words, with the files of the run, and `pictures` beside preview.png. The
/// last line names preview.png.
std::string run_summary(const nlohmann::ordered_json& figures, const std::filesystem::path& folder,
                        const std::vector<std::string>& formats,
                        const std::vector<std::string>& pictures = {}, bool surfaces = false);

/// A check of summary.json in words: the observed values, the allowed ones, and whether it held.
std::string check_line(const nlohmann::ordered_json& check);

}  // namespace meniscus::cli
