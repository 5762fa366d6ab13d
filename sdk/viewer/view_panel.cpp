// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the panel that chooses a view.
#include "sdk/viewer/view_panel.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "sdk/render/legend.h"
#include "sdk/scene/liquids.h"

namespace meniscus::viewer {
namespace {

using render::ParticleView;

constexpr struct {
  ParticleView view;
  const char* name;
} particle_views[] = {{ParticleView::surface, "surface"},
                      {ParticleView::speed, "particles: speed"},
                      {ParticleView::density_error, "particles: density error"},
                      {ParticleView::phase, "particles: phase"},
                      {ParticleView::pressure, "particles: pressure"}};

ImU32 shown_color(render::ColorMap map, float place) {
  const Vec3 c = color_at(map, place);
  const auto srgb = [](float x) { return std::pow(x, 1 / 2.2f); };
  return ImGui::ColorConvertFloat4ToU32({srgb(c.x), srgb(c.y), srgb(c.z), 1});
}

void draw_scale(const char* what, const render::Scale& scale) {
  const float width = ImGui::GetContentRegionAvail().x, height = 0.8f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr int bands = 64;
  for (int i = 0; i < bands; ++i) {
    const float left = at.x + width * static_cast<float>(i) / bands, right = left + width / bands;
    ImGui::GetWindowDrawList()->AddRectFilled({left, at.y}, {right + 1, at.y + height},
                                              shown_color(scale.map, (static_cast<float>(i) + 0.5f) / bands));
  }
  ImGui::Dummy({width, height});
  ImGui::TextDisabled("%s from %g to %g %s", what, double{scale.low}, double{scale.high}, scale.unit);
}

}  // namespace

void draw_liquid_choice(std::optional<Liquid>& liquid) {
  constexpr const char* own = "liquid: by the scene";
  constexpr auto liquids = names_of(Liquid{});
  const std::string shown =
      liquid ? std::string("liquid: ") + liquids[static_cast<std::size_t>(*liquid)].name : own;
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##liquid", shown.c_str())) return;
  if (ImGui::Selectable(own, !liquid)) liquid.reset();
  for (const auto& [name, value] : liquids) {
    if (ImGui::Selectable(name, liquid == value)) liquid = value;
  }
  ImGui::EndCombo();
}

void draw_view_panel(render::ViewChoice& choice, const render::ViewData& shown) {
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##particles", particle_views[static_cast<int>(choice.particles)].name)) {
    for (const auto& v : particle_views) {
      if (ImGui::Selectable(v.name, v.view == choice.particles)) choice.particles = v.view;
    }
    ImGui::EndCombo();
  }
  const float column = 0.5f * ImGui::GetContentRegionAvail().x;
  ImGui::Checkbox("contacts", &choice.contacts);
  ImGui::SameLine(column);
  ImGui::Checkbox("normals", &choice.normals);
  ImGui::Checkbox("cloth strain", &choice.strain);
  ImGui::SameLine(column);
  ImGui::Checkbox("distances", &choice.distances);
  if (choice.distances) {
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderFloat("##plane", &choice.plane, 0, 1, "plane at %.2f of the scene",
                       ImGuiSliderFlags_AlwaysClamp);
  }
  for (const render::LegendEntry& entry : render::legend_of(shown)) draw_scale(entry.name, entry.scale);
}

}  // namespace meniscus::viewer
