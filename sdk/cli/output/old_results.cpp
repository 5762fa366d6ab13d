// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Removes the files of an earlier run by the names that runs give them.
#include "sdk/cli/output/old_results.h"

#include <regex>
#include <vector>

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

void remove_matching(const fs::path& folder, const std::regex& names) {
  std::error_code ignored;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored) && std::regex_match(entry.path().filename().string(), names))
      found.push_back(entry.path());
  }
  for (const fs::path& file : found) fs::remove(file, ignored);
}

}  // namespace

void remove_old_results(const fs::path& folder) {
  static const std::regex figures(
      "(frames|bodies|cloths|attachments)\\.csv|summary\\.json|density\\.svg|(preview|contact_sheet)\\.png|"
      "(particles|diffuse|bodies|cloth|ropes|surface)\\.pvd");
  static const std::regex frames(
      "(frame|diffuse|bodies|cloth|ropes|surface)_[0-9]{5,}\\.(ply|vtp|obj)|render_[0-9]{5,}\\.png");
  remove_matching(folder, figures);
  remove_matching(folder / "frames", frames);
  std::error_code not_empty;
  fs::remove(folder / "frames", not_empty);
}

}  // namespace meniscus::cli
