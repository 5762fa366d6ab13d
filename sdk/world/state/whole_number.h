// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Whole numbers in JSON that nobody wrote on purpose.
#pragma once

#include <concepts>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace meniscus {

/// The number, or nothing if it is no whole one or does not fit. The library itself converts any number.
template <std::integral T>
std::optional<T> whole_number(const nlohmann::ordered_json& json) {
  const auto fitting = [](auto value) {
    return std::in_range<T>(value) ? std::optional<T>(static_cast<T>(value)) : std::nullopt;
  };
  if (json.is_number_unsigned()) return fitting(json.get<uint64_t>());
  if (json.is_number_integer()) return fitting(json.get<int64_t>());
  return std::nullopt;
}

}  // namespace meniscus
