// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What `meniscus check` says of a scene's mesh files.
#pragma once

#include <meniscus/scene.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace meniscus::cli {

/// Size, unit and defects of each mesh file, once. A mesh that is tiny or huge beside the particle spacing
/// has a warning; for others that is null.
nlohmann::ordered_json mesh_reports(const Scene& scene);

/// One of them in words, in lines of their own.
std::string mesh_text(const nlohmann::ordered_json& report);

}  // namespace meniscus::cli
