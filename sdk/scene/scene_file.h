// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scene files as JSON documents, for callers that edit them. scene_fields.h and sdk/fields/fields.h say what
// the keys are.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include <meniscus/scene.h>

namespace meniscus {

/// read_scene in two steps: the contents of the file with the overrides in it, and the scene that such
/// contents describe. Paths of mesh files start from the folder of `path`.
nlohmann::json read_document(const std::string& path, std::span<const std::string> overrides = {});
Scene scene_of_document(const nlohmann::json& document, const std::string& path);

/// The scene that a JSON document describes, its mesh files not looked for. `source` begins the message of
/// every error. Throws Error(parse).
Scene parse_scene(const nlohmann::json& document, const std::string& source = "scene");

}  // namespace meniscus
