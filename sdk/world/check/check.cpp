// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of single values, and the list of definitions that are checked.
#include "sdk/world/check/check.h"

#include <meniscus/bodies.h>
#include <meniscus/cloth.h>
#include <meniscus/flow.h>
#include <meniscus/motion.h>

#include <cmath>

#include "sdk/world/check/member_check.h"

namespace meniscus::check {

void refuse(const std::string& name, const std::string& value, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument, name + " is " + value + "; it must be " + allowed);
}

std::string text_of(Vec3 v) {
  std::ostringstream text;
  text << "(" << v.x << ", " << v.y << ", " << v.z << ")";
  return text.str();
}

std::string Place::text() const {
  if (!owner) return std::string(name);
  if (item >= 0) return owner->text() + "[" + std::to_string(item) + "]";
  return owner->text() + owner->mark + std::string(name);
}

namespace {

/// The bounds as floats. 0.01f is less than 0.01, and must still be allowed where the bound is 0.01.
FieldRule in_floats(const FieldRule& rule) {
  FieldRule rounded = rule;
  rounded.low = static_cast<float>(rule.low) * unit_of(rule);
  rounded.high = static_cast<float>(rule.high) * unit_of(rule);
  return rounded;
}

bool is_allowed(float x, const FieldRule& rule) {
  if (rule.or_infinite && x == std::numeric_limits<float>::infinity()) return true;
  return std::isfinite(x) && in_range(x, in_floats(rule));
}

/// As in "at least 0 and at most 1 m/s". For a value that is not finite it says "finite" if the range is
/// open.
std::string allowed_text(const Limits& limits, bool is_finite) {
  std::string text = range_text(limits.rule);
  const bool no_end = !std::isfinite(limits.rule.low) || !std::isfinite(limits.rule.high);
  if (text.empty()) return "finite";
  if (!is_finite && no_end && !limits.rule.or_infinite) text = "finite and " + text;
  if (*limits.unit) text += std::string(" ") + limits.unit;
  if (limits.rule.or_infinite) text += ", or infinity";
  return text;
}

template <class Whole>
void check_whole(const Place& place, Whole value, const Limits& limits) {
  if (!in_range(value, limits.rule)) refuse(place.text(), shown(value), allowed_text(limits, true));
}

}  // namespace

void check_number(const Place& place, float value, const Limits& limits) {
  if (is_allowed(value, limits.rule)) return;
  refuse(place.text(), shown(value) + (limits.rule.in_degrees ? " rad" : ""),
         allowed_text(limits, std::isfinite(value)));
}

void check_number(const Place& place, int value, const Limits& limits) {
  check_whole(place, value, limits);
}

void check_number(const Place& place, uint32_t value, const Limits& limits) {
  check_whole(place, value, limits);
}

void check_number(const Place& place, Vec3 value, const Limits& limits) {
  for (const float x : {value.x, value.y, value.z}) {
    if (!is_allowed(x, limits.rule))
      refuse(place.text(), text_of(value), allowed_text(limits, std::isfinite(x)) + " in each component");
  }
}

void check_number(const Place& place, Quat q, const Limits&) {
  const float norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (std::fabs(norm - 1) < 1e-3f) return;
  refuse(place.text(), "a quaternion with a squared length of " + shown(norm), "one with 1");
}

void check_count(const Place& place, std::size_t count, const FieldRule& rule) {
  const auto refuse_count = [&](const char* bound, std::size_t items) {
    refuse(place.text(), count == 0 ? "empty" : "a list of " + std::to_string(count),
           std::string("of ") + bound + std::to_string(items) + " items");
  };
  if (count < rule.min_items) refuse_count("at least ", rule.min_items);
  if (count > rule.max_items) refuse_count("at most ", rule.max_items);
}

void value(const char* name, float value, const FieldRule& rule, const char* unit) {
  check_number({name}, value, {rule, unit, ""});
}

void value(const char* name, int value, const FieldRule& rule, const char* unit) {
  check_number({name}, value, {rule, unit, ""});
}

void value(const char* name, Vec3 value, const FieldRule& rule, const char* unit) {
  check_number({name}, value, {rule, unit, ""});
}

void value(const char* name, const Pose& value) {
  check_fields({name}, const_cast<Pose&>(value));
}

void impulse(const char* name, Vec3 impulse, float mass) {
  value(name, impulse);
  constexpr float most = 1e9f;  // m/s: the squares of what steps make of it are still finite
  if (length(impulse) <= most * mass) return;
  std::ostringstream allowed;
  allowed << "at most " << most * mass << " N·s, which gives 1e9 m/s";
  refuse(name, text_of(impulse), allowed.str());
}

template void def(const WorldDef&);
template void def(const FluidDef&);
template void def(const GranularDef&);
template void def(const FluidVolumeDef&);
template void def(const SurfaceMeshDef&);
template void def(const ShapeDef&);
template void def(const BodyDef&);
template void def(const MotionFile&);
template void def(const JointDef&);
template void def(const ClothDef&);
template void def(const RopeDef&);
template void def(const AttachmentDef&);
template void def(const WindDef&);
template void def(const EmitterDef&);
template void def(const SinkDef&);
template void def(const ForceFieldDef&);
template void def(const ProbeDef&);

}  // namespace meniscus::check
