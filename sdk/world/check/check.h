// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of arguments. Each throws Error(invalid_argument) that names the argument, its value and what is
// allowed.
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/flow.h>

#include <string>

namespace meniscus::check {

[[noreturn]] void refuse(const char* name, const std::string& value, const std::string& allowed);
std::string text_of(Vec3 v);

void finite(const char* name, float value);
void finite(const char* name, Vec3 value);
void direction(const char* name, Vec3 value);  ///< see pbd::is_direction
void positive(const char* name, float value);
void not_negative(const char* name, float value);
void density(const char* name, float value);  ///< kg/m³, of what is made of particles: 0.001 to 1e6
void at_least(const char* name, float value, float lower);
void between(const char* name, float value, float lower, float upper);
void between(const char* name, int value, int lower, int upper);
void impulse(const char* name, Vec3 value, float mass);  ///< finite, and no more than gives `mass` 1e9 m/s
void box(const char* name, const Aabb& value);           ///< finite, lower ≤ upper on each axis
void pose(const char* name, const Pose& value);
void color(const char* name, Vec3 value);  ///< each from 0 to 1

/// Of an enumeration whose values go from 0 to `last`.
template <class E>
void one_of(const char* name, E value, E last) {
  between(name, static_cast<int>(value), 0, static_cast<int>(last));
}

void world(const WorldDef& def);
void fluid(const FluidDef& def);
void granular(const GranularDef& def);
void shape(const ShapeDef& def);
void body(const BodyDef& def);
void joint(const JointDef& def);
void cloth(const ClothDef& def);
void rope(const RopeDef& def);
void attachment(const AttachmentDef& def);
void wind(const WindDef& def);
void emitter(const EmitterDef& def);
void sink(const SinkDef& def);

}  // namespace meniscus::check
