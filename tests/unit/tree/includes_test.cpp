// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The source tree itself: which module and which folder may include which, and how many files a folder holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

using Edges = std::map<std::string, std::set<std::string>>;

/// The modules that each module may include, besides itself.
const Edges modules{
    {"pbd", {}},
    {"fluid", {"pbd"}},
    {"cloth", {"pbd"}},
    {"collision", {"pbd"}},
    {"sdk", {"pbd", "fluid", "cloth", "collision"}},
    {"samples", {"pbd", "fluid", "cloth", "collision", "sdk"}},
    {"tests", {"pbd", "fluid", "cloth", "collision", "sdk"}},
};

/// The folders of its own module that each folder may include, besides itself. Every source folder of a
/// module is listed. A folder stands below those that include it, so that there is no cycle.
const Edges folders{
    {"pbd/device/base", {}},
    {"pbd/math", {"pbd/device/base"}},
    {"pbd/device", {"pbd/device/base", "pbd/math"}},
    {"pbd/device/cpu", {"pbd/device", "pbd/device/base", "pbd/math"}},
    {"pbd/device/cuda", {"pbd/device", "pbd/device/base", "pbd/math"}},
    {"pbd/state", {"pbd/device", "pbd/device/base", "pbd/math"}},
    {"pbd/ranks", {"pbd/device/base"}},
    {"pbd",
     {"pbd/device", "pbd/device/base", "pbd/device/cpu", "pbd/device/cuda", "pbd/math", "pbd/ranks",
      "pbd/state"}},
    {"pbd/solver",
     {"pbd", "pbd/device", "pbd/device/base", "pbd/device/cpu", "pbd/device/cuda", "pbd/math", "pbd/ranks",
      "pbd/state"}},
    {"pbd/surface_tree", {"pbd", "pbd/device", "pbd/device/base", "pbd/math"}},

    {"fluid/kernel", {}},
    {"fluid/pressure_grid", {"fluid/kernel"}},
    {"fluid/density", {"fluid/kernel", "fluid/pressure_grid"}},
    {"fluid/baselines", {"fluid/kernel", "fluid/density"}},
    {"fluid/forces", {"fluid/kernel", "fluid/density"}},
    {"fluid/surface", {"fluid/kernel"}},
    {"fluid/diffuse", {"fluid/kernel"}},

    {"cloth/build", {}},
    {"cloth/solve", {"cloth/build"}},
    {"cloth/rods", {"cloth/solve"}},
    {"cloth/self_contact", {}},

    {"collision/mesh/file", {}},
    {"collision/mesh", {"collision/mesh/file"}},
    {"collision/sdf", {"collision/mesh"}},
    {"collision/contact", {"collision/mesh", "collision/sdf"}},
    {"collision/rigid_contact", {"collision/mesh"}},
    {"collision/rigid", {"collision/mesh", "collision/rigid_contact"}},
    {"collision/body", {"collision/contact", "collision/mesh", "collision/rigid", "collision/rigid_contact"}},
    {"collision/film", {"collision/body", "collision/contact", "collision/mesh", "collision/rigid"}},
    {"collision/fluid_cloth", {}},
    {"collision/grains", {"collision/contact"}},

    {"sdk/include/meniscus", {}},
    {"sdk/include/meniscus/c", {}},
    {"sdk/include/meniscus/device", {}},
    {"sdk/fields", {}},
    {"sdk/files", {}},
    {"sdk/engine/force_fields", {}},
    {"sdk/engine", {"sdk/engine/force_fields"}},
    {"sdk/world/check", {"sdk/fields"}},
    {"sdk/motion", {"sdk/fields", "sdk/world/check"}},
    {"sdk/world/solids", {"sdk/engine", "sdk/world/check"}},
    {"sdk/world/cloth", {"sdk/engine", "sdk/world/check"}},
    {"sdk/world/flow", {"sdk/engine", "sdk/world/check", "sdk/world/solids"}},
    {"sdk/world/state",
     {"sdk/engine", "sdk/fields", "sdk/files", "sdk/world/check", "sdk/world/cloth", "sdk/world/flow",
      "sdk/world/solids"}},
    {"sdk/world/host", {}},
    {"sdk/world/recording", {"sdk/fields", "sdk/files", "sdk/world/host", "sdk/world/state"}},
    {"sdk/world",
     {"sdk/engine", "sdk/fields", "sdk/world/check", "sdk/world/cloth", "sdk/world/flow", "sdk/world/host",
      "sdk/world/recording", "sdk/world/solids", "sdk/world/state"}},
    {"sdk/world/batch",
     {"sdk/engine", "sdk/world", "sdk/world/check", "sdk/world/queries", "sdk/world/state"}},
    {"sdk/world/shared", {"sdk/world"}},
    {"sdk/ranks", {}},
    {"sdk/world/queries", {"sdk/engine", "sdk/world", "sdk/world/check"}},
    {"sdk/world/replay", {"sdk/files", "sdk/world", "sdk/world/recording", "sdk/world/state"}},
    {"sdk/scene", {"sdk/fields", "sdk/world/check"}},
    {"sdk/c", {"sdk/fields", "sdk/io", "sdk/scene"}},
    {"sdk/io", {"sdk/files", "sdk/scene", "sdk/world/solids"}},
    {"sdk/io/preview", {"sdk/io", "sdk/scene"}},
    {"sdk/io/usd", {"sdk/files", "sdk/io", "sdk/io/preview"}},
    {"sdk/io/abc", {"sdk/files", "sdk/io", "sdk/io/usd"}},
    {"sdk/validation", {"sdk/files", "sdk/io"}},
    {"sdk/validation/cases", {"sdk/scene", "sdk/validation"}},
    {"sdk/render/gl", {}},
    {"sdk/render/frame", {"sdk/io", "sdk/io/preview", "sdk/scene"}},
    {"sdk/render/meshes", {"sdk/io", "sdk/render/frame", "sdk/render/gl"}},
    {"sdk/render/passes",
     {"sdk/io", "sdk/io/preview", "sdk/render/frame", "sdk/render/gl", "sdk/render/meshes"}},
    {"sdk/render", {"sdk/io", "sdk/render/frame", "sdk/render/gl", "sdk/render/meshes", "sdk/render/passes"}},
    {"sdk/viewer", {"sdk/fields", "sdk/io", "sdk/render", "sdk/render/frame", "sdk/scene"}},
    {"sdk/python/state", {"sdk/files", "sdk/world/state"}},
    {"sdk/python/values", {"sdk/fields", "sdk/python/state", "sdk/scene"}},
    {"sdk/python",
     {"sdk/io/preview", "sdk/python/state", "sdk/python/values", "sdk/world/host", "sdk/world/recording",
      "sdk/world/state"}},
    {"sdk/cli/record", {"sdk/fields", "sdk/files", "sdk/io", "sdk/scene"}},
    {"sdk/cli/output",
     {"sdk/cli/record", "sdk/io", "sdk/io/abc", "sdk/io/preview", "sdk/io/usd", "sdk/render", "sdk/scene",
      "sdk/world/shared"}},
    {"sdk/cli/stop", {}},
    {"sdk/cli/evidence", {"sdk/cli/stop", "sdk/fields", "sdk/scene"}},
    {"sdk/cli/usage", {"sdk/scene"}},
    {"sdk/cli/commands",
     {"sdk/cli/evidence", "sdk/cli/output", "sdk/cli/record", "sdk/cli/stop", "sdk/fields", "sdk/files",
      "sdk/io", "sdk/io/abc", "sdk/ranks", "sdk/scene", "sdk/cli/usage", "sdk/validation",
      "sdk/validation/cases", "sdk/viewer", "sdk/world/shared"}},
    {"sdk/cli/reproduce",
     {"sdk/cli/commands", "sdk/cli/evidence", "sdk/cli/output", "sdk/cli/stop", "sdk/io", "sdk/scene"}},
    {"sdk/cli", {"sdk/cli/commands", "sdk/cli/reproduce", "sdk/cli/usage", "sdk/io"}},
};

constexpr std::size_t most_files = 40;  ///< that a folder holds

const fs::path root = MENISCUS_SOURCE_DIR;

std::string folder_of(const std::string& file) {
  return fs::path(file).parent_path().generic_string();
}

std::string module_of(const std::string& file) {
  return file.substr(0, file.find('/'));
}

bool allows(const Edges& edges, const std::string& from, const std::string& to) {
  const auto row = edges.find(from);
  return from == to || (row != edges.end() && row->second.count(to));
}

/// The sources of all modules that end with one of these, as paths from the root.
std::vector<std::string> sources(const std::set<std::string>& endings) {
  std::vector<std::string> files;
  for (const auto& [module, below] : modules) {
    if (!fs::exists(root / module)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / module)) {
      if (entry.is_regular_file() && endings.count(entry.path().extension().string()))
        files.push_back(entry.path().lexically_relative(root).generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> cpp_sources() {
  return sources({".h", ".inl", ".cpp", ".cu", ".cuh"});
}

/// What a file includes in quotation marks.
std::vector<std::string> includes_of(const std::string& file) {
  std::vector<std::string> includes;
  std::ifstream in(root / file);
  const std::string start = "#include \"";
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(start, 0) != 0) continue;
    includes.push_back(line.substr(start.size(), line.find('"', start.size()) - start.size()));
  }
  return includes;
}

void for_each_include(const std::function<void(const std::string&, const std::string&)>& visit) {
  for (const std::string& file : cpp_sources()) {
    for (const std::string& included : includes_of(file)) visit(file, included);
  }
}

TEST(Tree, IncludesArePathsFromTheRoot) {
  ASSERT_GT(cpp_sources().size(), 100u) << "no sources in " << root;
  for_each_include([](const std::string& file, const std::string& included) {
    EXPECT_TRUE(fs::is_regular_file(root / included)) << file << " includes " << included;
  });
}

TEST(Tree, ModulesIncludeThoseBelowThem) {
  for_each_include([](const std::string& file, const std::string& included) {
    EXPECT_TRUE(allows(modules, module_of(file), module_of(included))) << file << " includes " << included;
  });
}

TEST(Tree, FoldersIncludeThoseBelowThem) {
  for_each_include([](const std::string& file, const std::string& included) {
    if (module_of(file) != module_of(included) || module_of(file) == "tests") return;
    EXPECT_TRUE(allows(folders, folder_of(file), folder_of(included)))
        << file << " includes " << included << ", which the table of folders does not allow";
  });
}

TEST(Tree, FoldersAreListed) {
  for (const std::string& file : cpp_sources()) {
    if (module_of(file) == "tests" || module_of(file) == "samples") continue;
    EXPECT_TRUE(folders.count(folder_of(file))) << file << " is in a folder that the table does not list";
  }
}

TEST(Tree, TheTablesHaveNoCycle) {
  for (const Edges& edges : {modules, folders}) {
    std::set<std::string> done;
    // As long as something can be taken away that stands on nothing but what was taken away before.
    for (std::size_t before = edges.size() + 1; done.size() != before;) {
      before = done.size();
      for (const auto& [from, below] : edges) {
        if (std::includes(done.begin(), done.end(), below.begin(), below.end())) done.insert(from);
      }
    }
    for (const auto& [from, below] : edges)
      EXPECT_TRUE(done.count(from)) << from << " is part of a cycle, or stands on one";
  }
}

TEST(Tree, NoFolderHoldsTooManyFiles) {
  std::map<std::string, std::size_t> count;
  for (const std::string& file : sources({".h", ".inl", ".cpp", ".cu", ".cuh", ".glsl"}))
    ++count[folder_of(file)];
  for (const auto& [folder, files] : count) EXPECT_LE(files, most_files) << folder;
}

}  // namespace
