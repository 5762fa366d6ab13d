// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads single values of a scene document.
#pragma once

#include <meniscus/types.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sdk/fields/rule.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {

// Plain values out of JSON. Each throws Error(parse) that names the place, the value and what is allowed.
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, float& value);
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, int& value);
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, uint32_t& value);
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, bool& value);
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule,
                std::string& value);
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, Vec3& value);
/// Four numbers, made a unit quaternion.
void read_plain(const nlohmann::json& json, const ScenePlace& place, const FieldRule& rule, Quat& value);

/// A value as an error shows it, cut short.
std::string shown(const nlohmann::json& json);

}  // namespace meniscus
