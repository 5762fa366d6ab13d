// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the viewer's panels.
#include "sdk/viewer/panels.h"

#include <imgui.h>

#include "sdk/viewer/stage_graph.h"
#include "sdk/viewer/view_panel.h"

namespace meniscus::viewer {
namespace {

constexpr ImGuiWindowFlags panel_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize;

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
  if (ImGui::Button(controls.parameters.need_reset() ? "Reset *" : "Reset", size)) controls.reset = true;
  if (controls.parameters.need_reset() && ImGui::IsItemHovered())
    ImGui::SetTooltip("Some of the parameters that were changed take effect at a reset");
  draw_pace(controls);
  ImGui::Checkbox("record a video", &controls.movie);
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

void draw_values(Controls& controls) {
  controls.parameters_changed |= controls.parameters.draw();
  const std::string options = controls.parameters.as_options();
  if (options.empty()) return;
  if (ImGui::Button("Copy as options")) ImGui::SetClipboardText(options.c_str());
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("What was changed, for the command line: %s", options.c_str());
}

void draw_parameters(Controls& controls) {
  const float margin = 0.6f * em();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x - margin, margin}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSizeConstraints({26 * em(), 0}, {26 * em(), screen.y - 2 * margin});
  ImGui::Begin("Values", nullptr, panel_flags);
  if (ImGui::CollapsingHeader("Parameters")) draw_values(controls);
  ImGui::End();
}

void draw_help() {
  static constexpr const char* lines[][2] = {
      {"drag a thing", "pull it"},
      {"drag elsewhere", "turn the view"},
      {"right button", "shift the view"},
      {"wheel", "nearer, further"},
      {"Space", "play, pause"},
      {"N", "next step"},
      {"R", "reset"},
      {"F", "see all"},
      {"V", "next view of particles"},
      {"P", "screenshot"},
      {"M", "begin or end a video"},
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
  ImGui::Begin("Meniscus", nullptr, panel_flags);
  draw_scene_list(controls, shown);
  draw_time(controls, shown);
  draw_messages(shown);
  if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_view_panel(controls.view, shown.snapshot.view);
    draw_liquid_choice(controls.liquid);
  }
  if (ImGui::CollapsingHeader("Timing", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_stage_graph(shown.history);
    draw_counts(shown);
  }
  if (ImGui::CollapsingHeader("Mouse and keys")) draw_help();
  ImGui::End();
  draw_parameters(controls);
}

}  // namespace meniscus::viewer
