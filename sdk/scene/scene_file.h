// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scene files: JSON in which every key is a field of Scene. Comments are allowed. scene_fields.h and
// sdk/fields/fields.h say what the keys are.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "sdk/scene/scene.h"

namespace meniscus {

/// Reads a scene file. Each override is `path=value`, as in `fluids[0].dynamic_viscosity=0.1`, and is written
/// into the file's contents before they are read; a value that is not JSON is taken as text. Mesh files are
/// looked for in the scene's folder, those that an override names in the current one, and `glmark2:bunny.obj`
/// where Debian's glmark2-data puts it, or in the folder that the environment's MENISCUS_GLMARK2_DIR names.
/// Throws Error: io for a file that cannot be read, parse for contents that are not a scene, invalid_argument
/// for an override that does not fit.
Scene read_scene(const std::string& path, std::span<const std::string> overrides = {});

/// The same in two steps: the contents of the file with the overrides in it, and the scene that such contents
/// describe, its mesh files looked for from where `path` lies.
nlohmann::json read_document(const std::string& path, std::span<const std::string> overrides = {});
Scene scene_of_document(const nlohmann::json& document, const std::string& path);

/// The scene that a JSON document describes, its mesh files not looked for. `source` begins the message of
/// every error. Throws Error(parse).
Scene parse_scene(const nlohmann::json& document, const std::string& source = "scene");

/// The JSON Schema (draft 2020-12) of scene files, as text. Where a value has a unit, it is there as `unit`.
std::string scene_schema();

}  // namespace meniscus
