// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds values of a scene document by their paths, and writes overrides of the form path=value.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace meniscus {

/// The value at a path such as `volumes[1].pose.position[0]`. Keys that are missing are made, with null;
/// items of arrays are not. Throws Error(invalid_argument), which begins with `option`.
nlohmann::json& value_at(nlohmann::json& document, std::string_view path, const std::string& option);

/// Writes `path=value` into a scene's document, as in `volumes[1].pose.position=[0, 2, 0]`. The value is
/// JSON, or text where it is not. Keys that are missing are made; items of arrays are not. A relative value
/// of a key `file` is made absolute, from the current folder. Throws Error(invalid_argument) that names the
/// override.
void apply_override(nlohmann::json& document, const std::string& override_text);

}  // namespace meniscus
