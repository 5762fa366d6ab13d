// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus samples`.
#include "sdk/cli/commands/samples.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/commands/scene_lookup.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {

int list_samples(bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& name : sample_names()) {
    if (json) {
      SceneChoice sample;
      sample.scene = name;
      const nlohmann::json document = chosen_document(sample);
      list.push_back(
          {{"name", name}, {"file", scene_path(name)}, {"description", document.value("description", "")}});
    } else {
      fmt::print("{}\n", io::plain_text(name));
    }
  }
  if (json) print_json(list);
  return success;
}

}  // namespace meniscus::cli
