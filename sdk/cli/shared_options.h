// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Options that several commands have.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli {

/// What the command line asks for. Its options live until it is called.
using Command = std::function<int()>;

CLI::Option* add_overrides(CLI::App& app, std::vector<std::string>& overrides);
CLI::Option* add_device(CLI::App& app, std::string& device);
void add_threads(CLI::App& app, std::optional<int>& threads);
void add_time_limit(CLI::App& app, double& minutes);
CLI::Option* add_json(CLI::App& app, bool& json);
void add_scene(CLI::App& app, std::string& scene, std::vector<std::string>& overrides);
/// With the device and its threads.
void add_scene(CLI::App& app, SceneChoice& choice);

}  // namespace meniscus::cli
