// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus::viewer {

/// A scene's document under the hands of a user. The schema of scene files says what there is to change, its
/// unit, its range and what it means.
class Parameters {
 public:
  Parameters();

  void open(nlohmann::json document);
  const nlohmann::json& document() const { return document_; }

  /// Dear ImGui's calls for all values; whether one was changed.
  bool draw();

  /// Some of the changes take effect when the world is built anew alone.
  bool need_reset() const { return needs_reset_; }
  /// The world was built from the document as it is.
  void was_reset() { needs_reset_ = false; }
  /// All changes since the document was opened, as options of the command line.
  std::string as_options() const;

 private:
  nlohmann::ordered_json schema_;
  nlohmann::json document_;
  std::map<std::string, std::string> changes_;  // by path, as text
  bool needs_reset_ = false;
};

/// Whether a running world can take over a change of the value at this path, as in `fluids[0].viscosity`.
bool changes_at_once(const std::string& path);

}  // namespace meniscus::viewer
