// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes results as JSON.
#include "sdk/cli/record/json_text.h"

#include <spdlog/fmt/fmt.h>

namespace meniscus::cli {

std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void print_json(const nlohmann::ordered_json& value) {
  fmt::print("{}", json_text(value));
}

double without_noise(double value) {
  return std::stod(fmt::format("{:.7g}", value));
}

}  // namespace meniscus::cli
