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
    const fs::file_type type = entry.symlink_status(ignored).type();
    if ((type == fs::file_type::regular || type == fs::file_type::symlink) &&
        std::regex_match(entry.path().filename().string(), names))
      found.push_back(entry.path());
  }
  for (const fs::path& file : found) fs::remove(file, ignored);
}

// A run that was killed leaves parts of files (see io::make_part).
const std::regex& figures() {
  static const std::regex names(
      "((frames|bodies|cloths|attachments|worlds)\\.csv|(summary|worlds)\\.json|density\\.svg|(preview|"
      "contact_sheet)\\.png|"
      "(particles|diffuse|bodies|cloth|ropes|surface)\\.pvd|scene\\.(usda|abc))(\\.[0-9a-f]{8}\\.part)?");
  return names;
}

const std::regex& frames() {
  static const std::regex names(
      "((frame|diffuse|bodies|cloth|ropes|surface)_[0-9]{5,}\\.(ply|vtp|obj)|(frame|diffuse)_[0-9]{5,}(\\.p|_"
      "of_rank_["
      "0-9]+\\.)vtp|shapes\\.(ply|vtp|obj)|liquid_["
      "0-9]{5,}\\.vdb|"
      "usd(_static|_manifest|\\.[0-9]{5,})\\.usda|render_[0-9]{5,}\\.png)"
      "(\\.[0-9a-f]{8}\\.part)?");
  return names;
}

}  // namespace

bool is_result(const fs::path& file, const fs::path& folder) {
  const std::string name = file.filename().string();
  return (file.parent_path() == folder && std::regex_match(name, figures())) ||
         (file.parent_path() == folder / "frames" && std::regex_match(name, frames()));
}

void remove_old_results(const fs::path& folder) {
  remove_matching(folder, figures());
  std::error_code unknown;
  if (fs::is_symlink(folder / "frames", unknown)) return;
  remove_matching(folder / "frames", frames());
  std::error_code not_empty;
  fs::remove(folder / "frames", not_empty);
}

}  // namespace meniscus::cli
