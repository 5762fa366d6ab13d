// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes overrides of the form path=value into a scene document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace meniscus {

/// Writes `path=value` into a scene's document, as in `volumes[1].pose.position=[0, 2, 0]`. The value is
/// JSON, or text where it is not. Keys that are missing are made; items of arrays are not. A relative value
/// of a key `file` is made absolute, from the current folder. Throws Error(invalid_argument) that names the
/// override.
void apply_override(nlohmann::json& document, const std::string& override_text);

}  // namespace meniscus
