// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/shared_options.h"

namespace meniscus::cli {

CLI::Option* add_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  return app
      .add_option("--set", overrides,
                  "Change a value of the scene, as in fluids[0].dynamic_viscosity=0.1; repeatable")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* add_device(CLI::App& app, std::string& device) {
  return app.add_option("--device", device, "Where to run; by default what the scene says")
      ->type_name("auto|cpu|cuda")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""));
}

void add_threads(CLI::App& app, std::optional<int>& threads) {
  app.add_option("--threads", threads, "Threads of the CPU device; 0 is one a core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""));
}

void add_time_limit(CLI::App& app, double& minutes) {
  app.add_option("--time-limit", minutes, "End after this time, and write what there is; by default no limit")
      ->type_name("MINUTES")
      ->check(CLI::Range(0.0, 1e5).description(""));
}

CLI::Option* add_json(CLI::App& app, bool& json) {
  return app.add_flag("--json", json, "Print the results as JSON, for other programs");
}

void add_scene(CLI::App& app, std::string& scene, std::vector<std::string>& overrides) {
  app.add_option("scene", scene, "A scene file, or the name of a sample")->required()->type_name("SCENE");
  add_overrides(app, overrides);
}

void add_scene(CLI::App& app, SceneChoice& choice) {
  add_scene(app, choice.scene, choice.overrides);
  add_device(app, choice.device);
  add_threads(app, choice.threads);
}

}  // namespace meniscus::cli
