// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws an input field for each value of a JSON document.
#include "sdk/viewer/parameter_fields.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meniscus::viewer {
namespace {

using Json = nlohmann::json;
using Schema = nlohmann::ordered_json;

bool is_vector(const Schema& schema) {
  return schema.value("type", "") == "array" && schema.contains("maxItems") &&
         schema["items"].value("type", "") == "number";
}

/// The alternative that matches the value, by its type or by its form.
const Schema* chosen(const Schema& schema, const Json& value) {
  if (!schema.contains("oneOf")) return &schema;
  for (const Schema& way : schema["oneOf"]) {
    if (way.value("type", "") == "array" && value.is_array()) return &way;
    if (way.value("type", "") != "object" || !value.is_object()) continue;
    const Schema& keys = way["properties"];
    if (!keys.contains("type") ||
        (value.contains("type") && keys["type"].value("const", "") == value.value("type", "")))
      return &way;
  }
  return nullptr;
}

/// A format for a number with its unit; ImGui writes and reads numbers with it.
std::string format_of(const Schema& schema, const char* number) {
  std::string format = number;
  const std::string unit = schema.value("unit", "");
  if (!unit.empty()) format += ' ';
  for (const char c : unit) format.append(c == '%' ? 2 : 1, c);
  return format;
}

struct Range {
  double low, high;
};

Range range_of(const Schema& schema) {
  const auto limit = [&](const char* key, const char* open_key, double otherwise) {
    return schema.contains(key) ? schema[key].get<double>() : schema.value(open_key, otherwise);
  };
  constexpr double far = std::numeric_limits<float>::max() / 4;
  return {limit("minimum", "exclusiveMinimum", -far), limit("maximum", "exclusiveMaximum", far)};
}

/// A drag field, or a slider if the range is short. Numbers with an exclusive limit stay off it.
bool edit_numbers(const Schema& schema, const Schema& number, double* values, int count) {
  const Range range = range_of(number);
  const std::string format = format_of(schema, "%.4g");
  bool changed;
  double largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(values[i]));
  if (range.high - range.low <= 20) {
    changed = ImGui::SliderScalarN("##v", ImGuiDataType_Double, values, count, &range.low, &range.high,
                                   format.c_str());
  } else {
    const auto speed = static_cast<float>(largest > 0 ? 0.01 * largest : 0.01);
    changed = ImGui::DragScalarN("##v", ImGuiDataType_Double, values, count, speed, &range.low, &range.high,
                                 format.c_str());
  }
  for (int i = 0; changed && i < count; ++i) {
    values[i] = std::clamp(values[i], range.low, range.high);
    const double step = 1e-4 * std::max(std::min(range.high - range.low, largest), 1e-4);
    if (number.contains("exclusiveMinimum") && values[i] <= range.low) values[i] = range.low + step;
    if (number.contains("exclusiveMaximum") && values[i] >= range.high) values[i] = range.high - step;
  }
  return changed;
}

bool edit_number(const Schema& schema, Json& value) {
  double number = value.get<double>();
  if (!edit_numbers(schema, schema, &number, 1)) return false;
  value = number;
  return true;
}

bool edit_vector(const Schema& schema, Json& value) {
  double numbers[4] = {};
  const auto count = std::min<std::size_t>(value.size(), 4);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = value[i].get<double>();
  if (!edit_numbers(schema, schema["items"], numbers, static_cast<int>(count))) return false;
  value = std::vector<double>(numbers, numbers + count);
  return true;
}

bool edit_whole(const Schema& schema, Json& value) {
  const Range range = range_of(schema);
  constexpr double most = std::numeric_limits<int>::max() / 2;
  const int low = static_cast<int>(std::max(range.low, -most)),
            high = static_cast<int>(std::min(range.high, most));
  int number = value.get<int>();
  const std::string format = format_of(schema, "%d");
  const float speed = std::max(0.05f, 0.01f * static_cast<float>(std::abs(number)));
  if (!ImGui::DragInt("##v", &number, speed, low, high, format.c_str(), ImGuiSliderFlags_AlwaysClamp))
    return false;
  value = number;
  return true;
}

bool edit_choice(const Schema& schema, Json& value) {
  const std::string present = value.get<std::string>();
  bool changed = false;
  if (!ImGui::BeginCombo("##v", present.c_str())) return false;
  for (const Schema& name : schema["enum"]) {
    const auto text = name.get<std::string>();
    if (!ImGui::Selectable(text.c_str(), text == present) || text == present) continue;
    value = text;
    changed = true;
  }
  ImGui::EndCombo();
  return changed;
}

bool edit_switch(Json& value) {
  bool on = value.get<bool>();
  if (!ImGui::Checkbox("##v", &on)) return false;
  value = on;
  return true;
}

/// A zero value of the schema's form, for values without a default.
Json blank(const Schema& schema) {
  if (schema.contains("enum")) return schema["enum"][0].get<std::string>();
  if (is_vector(schema)) return std::vector<double>(schema["maxItems"].get<std::size_t>(), 0.0);
  const std::string type = schema.value("type", "");
  if (type == "boolean") return false;
  if (type == "string") return "";
  if (type == "integer") return schema.value("minimum", 0);
  return std::max(0.0, range_of(schema).low);
}

/// The user's name of a list item.
std::string title_of(const Json& item, std::size_t index) {
  if (item.is_object() && item.contains("name") && item["name"].is_string())
    return item["name"].get<std::string>();
  return std::to_string(index);
}

/// Whether the window does not need this key.
bool is_for_files(const std::string& key) {
  static constexpr std::array keys{"$schema", "type", "name", "description", "frames", "camera", "cameras"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void explain(const Schema& schema, bool at_once) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(28 * ImGui::GetFontSize());
  ImGui::TextUnformatted(schema.value("description", "").c_str());
  if (!at_once) ImGui::TextDisabled("takes effect at a reset");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

void ParameterFields::draw_object(const Schema& schema, Json& object, const std::string& path) {
  for (const auto& [key, property] : schema["properties"].items()) {
    if (is_for_files(key)) continue;
    draw_property(key, property, object, path.empty() ? key : path + "." + key);
  }
}

void ParameterFields::draw_property(const std::string& key, const Schema& schema, Json& parent,
                                    const std::string& path) {
  if (key == "belt_velocity" && path.starts_with("bodies")) return;  // a fixed shape's alone
  const bool is_there = parent.contains(key);
  const Schema* form = is_there ? chosen(schema, parent[key]) : &schema;
  if (!form || form->contains("oneOf")) return;
  const std::string type = form->value("type", "");
  if (type == "object") {
    // Values are set one at a time, so what needs several at once cannot be made here.
    if (!is_there && form->contains("required")) return;
    Json none = Json::object();
    Json& object = is_there ? parent[key] : none;
    if (!ImGui::TreeNode(key.c_str())) return;
    draw_object(*form, object, path);
    if (!is_there && !object.empty()) parent[key] = std::move(object);
    ImGui::TreePop();
  } else if (type == "array" && !is_vector(*form)) {
    if (is_there) draw_list(key, (*form)["items"], parent[key], path);
  } else {
    draw_value(key, *form, parent, path);
  }
}

void ParameterFields::draw_list(const std::string& key, const Schema& schema, Json& list,
                                const std::string& path) {
  const bool of_objects = !list.empty() && list[0].is_object();
  if (!of_objects || !ImGui::TreeNode(key.c_str())) return;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Schema* form = chosen(schema, list[i]);
    if (!form || !ImGui::TreeNode(reinterpret_cast<void*>(i), "%s", title_of(list[i], i).c_str())) continue;
    draw_object(*form, list[i], path + "[" + std::to_string(i) + "]");
    ImGui::TreePop();
  }
  ImGui::TreePop();
}

void ParameterFields::draw_value(const std::string& key, const Schema& schema, Json& parent,
                                 const std::string& path) {
  const bool is_there = parent.contains(key), at_once = at_once_(path);
  Json value =
      is_there ? parent[key] : (schema.contains("default") ? Json(schema["default"]) : blank(schema));
  ImGui::PushID(key.c_str());
  ImGui::SetNextItemWidth(0.52f * ImGui::GetWindowWidth());
  if (edit(schema, value)) {
    parent[key] = value;
    changes_[path] = value;
  }
  explain(schema, at_once);
  ImGui::SameLine();
  if (is_there)
    ImGui::Text("%s%s", key.c_str(), at_once ? "" : " *");
  else
    ImGui::TextDisabled("%s%s", key.c_str(), at_once ? "" : " *");
  explain(schema, at_once);
  ImGui::PopID();
}

bool ParameterFields::edit(const Schema& schema, Json& value) const {
  if (schema.contains("enum")) return edit_choice(schema, value);
  if (is_vector(schema)) return edit_vector(schema, value);
  const std::string type = schema.value("type", "");
  if (type == "boolean") return edit_switch(value);
  if (type == "integer") return edit_whole(schema, value);
  if (type == "number") return edit_number(schema, value);
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  ImGui::TextDisabled("%s", text.c_str());  // names and files are edited in the scene's file
  return false;
}

}  // namespace meniscus::viewer
