// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A scene's document while the user edits it.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus::viewer {

/// A scene's document that the user edits. The schema of scene files gives the values, their units, ranges
/// and meanings.
class Parameters {
 public:
  Parameters();

  void open(nlohmann::json document);
  const nlohmann::json& document() const { return document_; }

  /// Calls Dear ImGui for all values; returns whether one changed.
  bool draw();

  /// Whether some changes only take effect when the world is built anew.
  bool need_reset() const { return needs_reset_; }
  /// Call it when the world was built from the present document.
  void was_reset() { needs_reset_ = false; }
  /// All changes since the document was opened, as command-line options.
  std::string as_options() const;

 private:
  nlohmann::ordered_json schema_;
  nlohmann::json document_;
  std::map<std::string, std::string> changes_;  // by path, as text
  bool needs_reset_ = false;
};

/// Whether a running world can apply a change of the value at this path, for example
/// `fluids[0].dynamic_viscosity`.
bool changes_at_once(const std::string& path);

}  // namespace meniscus::viewer
