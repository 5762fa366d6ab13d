// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Loads the font and sets colours and sizes.
#include "sdk/viewer/style.h"

#include <imgui.h>

#include <filesystem>

namespace meniscus::viewer {
namespace {

/// ImGui's own font lacks Greek letters and most other symbols of units and formulas.
void load_font(float pixels) {
  static constexpr ImWchar letters[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x203A,
                                        0x2070, 0x209F, 0x2190, 0x22FF, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"}) {
    std::error_code missing;
    if (!std::filesystem::is_regular_file(file, missing)) continue;
    if (fonts.AddFontFromFileTTF(file, pixels, nullptr, letters)) return;
  }
  fonts.AddFontDefault();
}

}  // namespace

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
  style.WindowBorderSize = 0;
  style.FramePadding = {7, 3};
  style.ItemSpacing = {7, 5};
  const ImVec4 water{0.16f, 0.47f, 0.72f, 1}, bright{0.25f, 0.60f, 0.88f, 1};
  style.Colors[ImGuiCol_WindowBg] = {0.07f, 0.08f, 0.10f, 0.90f};
  style.Colors[ImGuiCol_PopupBg] = {0.09f, 0.10f, 0.13f, 0.97f};
  style.Colors[ImGuiCol_FrameBg] = {0.17f, 0.19f, 0.23f, 1};
  style.Colors[ImGuiCol_FrameBgHovered] = {0.22f, 0.25f, 0.30f, 1};
  style.Colors[ImGuiCol_Header] = {0.15f, 0.20f, 0.26f, 1};
  style.Colors[ImGuiCol_HeaderHovered] = style.Colors[ImGuiCol_ButtonHovered] = water;
  style.Colors[ImGuiCol_Button] = {0.18f, 0.24f, 0.31f, 1};
  style.Colors[ImGuiCol_ButtonActive] = style.Colors[ImGuiCol_HeaderActive] = bright;
  style.Colors[ImGuiCol_SliderGrab] = water;
  style.Colors[ImGuiCol_SliderGrabActive] = style.Colors[ImGuiCol_CheckMark] = bright;
  style.ScaleAllSizes(scale);
  load_font(14 * scale);
}

}  // namespace meniscus::viewer
