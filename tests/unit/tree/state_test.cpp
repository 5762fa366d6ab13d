// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// No part is left out of snapshots: what a failed step restores is state, and so is what each part says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = MENISCUS_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The members of DeviceEngine that keep nothing from one step to the next, or only what follows from models,
/// definitions and results that the world has read.
const std::set<std::string> stateless{
    "contacts_",     // shapes' contacts are found anew, and filters come with the materials
    "attachments_",  // the world has read their impulses
    "films_",        // made anew in each substep
    "forces_",       // made from the definitions
    "pistons_",      // made from the ducts of emitters
    "effective_mass_", "tree_",      "contact_set_", "fluid_cloth_contacts_",
    "tension_",        "viscosity_", "smoothing_",
    "probes_",  // the world has read their values
    "mesher_",         "removal_",   "sinks_",       "free_room_",
    "mesh_fields_",  // made from the solids
};

TEST(State, TheEngineListsEachPart) {
  const std::string engine = text_of(root / "sdk/engine/engine.inl");
  const std::string listed = text_of(root / "sdk/engine/engine_state.inl");
  const std::regex member(R"(\n  (?:std::optional<)?(?:\w+::)*[A-Z]\w*<D>>? (\w+_);)");
  std::size_t parts = 0;
  for (std::sregex_iterator at(engine.begin(), engine.end(), member), end; at != end; ++at) {
    const std::string name = (*at)[1];
    ++parts;
    const bool is_listed = listed.find(", " + name + ")") != std::string::npos ||
                           listed.find(", *" + name + ")") != std::string::npos;
    EXPECT_NE(is_listed, stateless.count(name) > 0) << name << " must be in visit_state or stateless";
  }
  EXPECT_GT(parts, 20u);
}

/// Calls that change a world but stand in recordings otherwise, or not at all.
const std::set<std::string> not_replayed{
    "step",         "step_begin", "step_end",  // by a record of their own
    "restore",                                 // as a state
    "set_progress", "add_hook",   "remove_hook", "start_recording", "stop_recording"};

TEST(State, RecordingsHaveEachCallThatChangesAWorld) {
  const std::string header = text_of(root / "sdk/include/meniscus/world.h");
  const std::string table = text_of(root / "sdk/world/recording/replayed_calls.cpp");
  const std::regex call(R"(\n  (?:void|[A-Z]\w+|std::size_t) ([a-z]\w+)\([^;]*?\)( const)?(?: noexcept)?;)"),
      entry(R"re(\{"\w+")re");
  std::multiset<std::string> changing;
  for (std::sregex_iterator at(header.begin(), header.end(), call), end; at != end; ++at) {
    if (!(*at)[2].matched && (*at)[1] != "cancel" && !not_replayed.count((*at)[1])) changing.insert((*at)[1]);
  }
  const auto entries = std::distance(std::sregex_iterator(table.begin(), table.end(), entry), {});
  EXPECT_EQ(static_cast<std::size_t>(entries), changing.size());
  for (const std::string& name : changing)
    EXPECT_TRUE(table.find("World::" + name) != std::string::npos ||
                table.find("{\"" + name + "\"") != std::string::npos)
        << name << " must be in the table, or not_replayed";
  EXPECT_GT(changing.size(), 50u);
}

TEST(State, WhatAFailedStepRestoresIsVisited) {
  const std::regex restores(R"(void (restore|undo_step)\(\) override(?! \{\}))");
  std::size_t sets = 0;
  for (const char* module : {"fluid", "cloth", "collision"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / module)) {
      if (entry.path().extension() != ".h") continue;
      const std::string text = text_of(entry.path());
      if (!std::regex_search(text, restores)) continue;
      ++sets;
      EXPECT_NE(text.find("visit_state("), std::string::npos) << entry.path();
    }
  }
  EXPECT_GE(sets, 8u);
}

}  // namespace
