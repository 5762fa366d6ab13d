// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/viewer/panels.h"

#include <imgui.h>

#include "sdk/viewer/stage_graph.h"

namespace meniscus::viewer {
namespace {

float em() {
  return ImGui::GetFontSize();
}

void draw_scene_list(Controls& controls, const Shown& shown) {
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##scene", shown.scene.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const std::string& name : shown.scenes) {
      if (ImGui::Selectable(name.c_str(), name == shown.scene)) controls.open = name;
    }
    ImGui::EndCombo();
  }
  if (shown.snapshot.scene && !shown.snapshot.scene->description.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", shown.snapshot.scene->description.c_str());
    ImGui::PopStyleColor();
  }
}

void draw_pace(Controls& controls) {
  static constexpr struct {
    const char* name;
    double pace;
  } choices[] = {{"a tenth of real time", 0.1},
                 {"a quarter of real time", 0.25},
                 {"half of real time", 0.5},
                 {"real time", 1},
                 {"as fast as it can", 0}};
  const char* present = "";
  for (const auto& c : choices) {
    if (c.pace == controls.pace) present = c.name;
  }
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##pace", present)) return;
  for (const auto& c : choices) {
    if (ImGui::Selectable(c.name, c.pace == controls.pace)) controls.pace = c.pace;
  }
  ImGui::EndCombo();
}

void draw_time(Controls& controls, const Shown& shown) {
  const Snapshot& now = shown.snapshot;
  const ImVec2 size{(ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3, 0};
  if (ImGui::Button(now.playing ? "Pause" : "Play", size)) controls.play = !now.playing;
  ImGui::SameLine();
  if (ImGui::Button("Step", size)) controls.step = true;
  ImGui::SameLine();
  if (ImGui::Button(controls.scene_needs_reset ? "Reset *" : "Reset", size)) controls.reset = true;
  if (controls.scene_needs_reset && ImGui::IsItemHovered())
    ImGui::SetTooltip("Some of the parameters that were changed take effect at a reset");
  draw_pace(controls);
  ImGui::Text("%.3f s after %llu steps", now.time, static_cast<unsigned long long>(now.steps));
}

void draw_counts(const Shown& shown) {
  const Snapshot& now = shown.snapshot;
  ImGui::TextDisabled("%s", now.device.name.c_str());
  if (!now.positions.empty())
    ImGui::TextDisabled("%zu particles, %u contacts", now.positions.size(), now.step.contacts);
  if (!now.cloth.triangles.empty()) ImGui::TextDisabled("%zu triangles of cloth", now.cloth.triangles.size());
  if (!now.bodies.empty()) ImGui::TextDisabled("%zu bodies", now.bodies.size());
  ImGui::TextDisabled("drawn in %.1f ms", shown.paint_ms);
}

void draw_messages(const Shown& shown) {
  if (shown.is_building) ImGui::TextUnformatted("Building the scene ...");
  if (!shown.snapshot.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.45f, 0.35f, 1));
    ImGui::TextWrapped("%s", shown.snapshot.error.c_str());
    ImGui::PopStyleColor();
  }
  if (!shown.notice.empty()) ImGui::TextWrapped("%s", shown.notice.c_str());
}

void draw_help() {
  static constexpr const char* lines[][2] = {
      {"drag", "turn the view"},
      {"right button", "shift the view"},
      {"wheel", "nearer, further"},
      {"Space", "play, pause"},
      {"N", "next step"},
      {"R", "reset"},
      {"F", "see all"},
      {"P", "screenshot"},
      {"Tab", "hide panels"},
      {"Esc", "close"},
  };
  if (!ImGui::BeginTable("help", 2)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
  for (const auto& line : lines) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(line[0]);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", line[1]);
  }
  ImGui::EndTable();
}

}  // namespace

void draw_panels(Controls& controls, const Shown& shown) {
  const float margin = 0.6f * em();
  ImGui::SetNextWindowPos({margin, margin}, ImGuiCond_Always);
  ImGui::SetNextWindowSizeConstraints({22 * em(), 0}, {22 * em(), ImGui::GetIO().DisplaySize.y - 2 * margin});
  ImGui::Begin("Meniscus", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize);
  draw_scene_list(controls, shown);
  draw_time(controls, shown);
  draw_messages(shown);
  if (ImGui::CollapsingHeader("Timing", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_stage_graph(shown.history);
    draw_counts(shown);
  }
  if (ImGui::CollapsingHeader("Mouse and keys")) draw_help();
  ImGui::End();
}

}  // namespace meniscus::viewer
