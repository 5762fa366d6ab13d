// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The panel of values, drawn by Dear ImGui with no window, under a mouse that is not there.
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>

#include "sdk/scene/scene_file.h"
#include "sdk/viewer/parameters.h"

namespace meniscus::viewer {
namespace {

namespace fs = std::filesystem;

class ParameterPanelTest : public testing::Test {
 protected:
  static constexpr float width = 500, height = 4000;

  ParameterPanelTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    io.DeltaTime = 1 / 60.0f;
    unsigned char* pixels = nullptr;
    int w = 0, h = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &w, &h);
  }
  ~ParameterPanelTest() override { ImGui::DestroyContext(); }

  /// With everything folded out, which is what a log of it does; whether a value was changed.
  bool draw(Parameters& parameters) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("values", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
    ImGui::LogToClipboard(100);
    const bool changed = parameters.draw();
    ImGui::LogFinish();
    ImGui::End();
    ImGui::Render();
    return changed;
  }
  bool draw_at(Parameters& parameters, float x, float y, bool pressed) {
    ImGui::GetIO().MousePos = {x, y};
    ImGui::GetIO().MouseDown[0] = pressed;
    return draw(parameters);
  }
  /// Drags to the right, from each place on the left of the panel; how many drags changed something.
  int drag_everywhere(Parameters& parameters) {
    int changes = 0;
    for (float y = 12; y < height; y += 12) {
      draw_at(parameters, 120, y, false);
      bool changed = draw_at(parameters, 120, y, true);
      for (float x = 125; x < 150; x += 5) changed |= draw_at(parameters, x, y, true);
      changed |= draw_at(parameters, 150, y, false);
      changes += changed;
    }
    return changes;
  }
};

std::vector<fs::path> samples() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(MENISCUS_SAMPLES_DIR) / "scenes")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  return files;
}

TEST_F(ParameterPanelTest, EverySampleIsShownAndLeftAsItIs) {
  for (const fs::path& file : samples()) {
    Parameters parameters;
    const nlohmann::json document = read_document(file.string());
    parameters.open(document);
    EXPECT_FALSE(draw(parameters)) << file;
    EXPECT_FALSE(draw(parameters)) << file;
    EXPECT_EQ(parameters.document(), document) << file;
    EXPECT_FALSE(parameters.need_reset());
    EXPECT_EQ(parameters.as_options(), "");
  }
}

const char* const scene = R"({
  "name": "drops", "world": { "substeps": 4 },
  "fluids": [{ "name": "water" }, { "name": "oil", "rest_density": 900 }],
  "shapes": [{ "name": "floor", "geometry": { "type": "plane" } }],
  "bodies": [{ "name": "ball", "geometry": { "type": "sphere", "radius": 0.3 }, "pose": { "position": [0, 2, 0] } }],
  "cloths": [{ "name": "sheet", "geometry": { "type": "sheet" }, "fabric": { "unyielding": ["warp"] } }],
  "volumes": [{ "fluid": "oil", "region": { "type": "ball", "radius": 0.2 } }]
})";

TEST_F(ParameterPanelTest, WhateverIsDraggedTheSceneStaysOne) {
  Parameters parameters;
  parameters.open(nlohmann::json::parse(scene));
  EXPECT_GT(drag_everywhere(parameters), 40);
  EXPECT_TRUE(parameters.need_reset());
  EXPECT_NE(parameters.document(), nlohmann::json::parse(scene));
  const Scene changed = parse_scene(parameters.document());
  EXPECT_EQ(changed.fluids.at(1).name, "oil");
  // The changes are told as options of the command line.
  EXPECT_NE(parameters.as_options().find("--set 'fluids[1].dynamic_viscosity="), std::string::npos)
      << parameters.as_options();
  parameters.was_reset();
  EXPECT_FALSE(parameters.need_reset());
}

}  // namespace
}  // namespace meniscus::viewer
