// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Results as JSON, for other programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace meniscus::cli {

/// As text with a line end. Bytes that are not UTF-8, as file names may have, become U+FFFD.
std::string json_text(const nlohmann::ordered_json& value);

/// Prints it on stdout.
void print_json(const nlohmann::ordered_json& value);

/// 0.016 rather than 0.01600000076: a float has seven digits.
double without_noise(double value);

}  // namespace meniscus::cli
