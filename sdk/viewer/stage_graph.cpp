// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the bars and the legend of the stages' times.
#include "sdk/viewer/stage_graph.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace meniscus::viewer {
namespace {

/// Colours of the stages, and of the remaining host time.
constexpr ImU32 colors[stage_count + 1] = {
    IM_COL32(110, 168, 254, 255), IM_COL32(80, 200, 180, 255),  IM_COL32(155, 205, 95, 255),
    IM_COL32(245, 200, 75, 255),  IM_COL32(240, 140, 70, 255),  IM_COL32(225, 95, 120, 255),
    IM_COL32(175, 125, 225, 255), IM_COL32(120, 125, 135, 255),
};

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= value) return digit * power;
  }
  return 10 * power;
}

/// ms: the time that is not in the stages.
double rest_of(double step, const std::array<double, stage_count>& stages) {
  for (const double ms : stages) step -= ms;
  return std::max(step, 0.0);
}

void draw_bar(ImDrawList& list, float x, float width, float bottom, float per_ms, const StepReport& step) {
  float y = bottom;
  const auto add = [&](double ms, ImU32 color) {
    const float top = y - per_ms * static_cast<float>(ms);
    list.AddRectFilled({x, top}, {x + width, y}, color);
    y = top;
  };
  for (std::size_t i = 0; i < stage_count; ++i) add(step.stage_ms[i], colors[i]);
  add(rest_of(step.ms, step.stage_ms), colors[stage_count]);
}

void draw_entry(const char* name, double ms, ImU32 color) {
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = 0.6f * ImGui::GetFontSize(), down = 0.25f * ImGui::GetFontSize();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + down}, {at.x + size, at.y + down + size}, color, 2);
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  ImGui::Text("%s", name);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%.2f", ms);
}

void draw_legend(const StageHistory::Means& means) {
  if (!ImGui::BeginTable("stages", 4, ImGuiTableFlags_SizingStretchProp)) return;
  for (std::size_t i = 0; i < stage_count; ++i)
    draw_entry(stage_name(static_cast<Stage>(i)), means.stages[i], colors[i]);
  draw_entry("host", rest_of(means.step, means.stages), colors[stage_count]);
  ImGui::EndTable();
}

}  // namespace

void draw_stage_graph(const StageHistory& history) {
  const StageHistory::Means means = history.means();
  double most = 1e-3;
  for (const StepReport& step : history.steps()) most = std::max(most, step.ms);
  const double top = round_up(most);
  const float width = ImGui::GetContentRegionAvail().x, height = 5.5f * ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
  const float bar = width / StageHistory::most_steps, bottom = corner.y + height;
  float x = corner.x + width - bar * static_cast<float>(history.steps().size());
  for (const StepReport& step : history.steps()) {
    draw_bar(list, x, bar, bottom, height / static_cast<float>(top), step);
    x += bar;
  }
  char label[32];
  std::snprintf(label, sizeof label, "%g ms", top);
  list.AddText({corner.x + 4, corner.y + 2}, ImGui::GetColorU32(ImGuiCol_TextDisabled), label);
  ImGui::Dummy({width, height});
  ImGui::Text("%.2f ms a step", means.step);
  draw_legend(means);
}

}  // namespace meniscus::viewer
