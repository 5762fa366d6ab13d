// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks the parameters of rods and ropes, and builds their segments, frames and masses.
#include "cloth/rods/rod.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "cloth/rods/tuning.h"
#include "pbd/contacts.h"

namespace meniscus::cloth {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw Error(ErrorCode::invalid_argument, text.str());
}

const char* kind_of(const RodParameters& p) {
  return p.bends_and_twists ? "rod" : "rope";
}

void check(const RodParameters& p) {
  const auto check_positive = [&](const char* name, float value) {
    if (!(value > 0)) refuse("the ", name, " of a ", kind_of(p), " is ", value, "; it must be > 0");
  };
  check_positive("radius", p.radius);
  check_positive("density", p.density);
  check_positive("Young's modulus", p.youngs_modulus);
  check_positive("shear modulus", p.shear_modulus);
  check_positive("stretch stiffness", p.stretch_stiffness.value_or(1));
  check_positive("bending stiffness", p.bending_stiffness.value_or(1));
  check_positive("twist stiffness", p.twist_stiffness.value_or(1));
  if (!std::isfinite(p.radius) || !std::isfinite(p.density))
    refuse("the radius and the density of a ", kind_of(p), " must be finite");
  if (!std::isfinite(p.damping) || p.damping < 0)
    refuse("the damping of a ", kind_of(p), " is ", p.damping, "; it must be finite and ≥ 0");
}

void check(std::span<const Vec3> points, const RodParameters& p) {
  const bool closed = p.closed;
  const size_t least = closed ? 3 : 2;
  if (points.size() < least)
    refuse(closed ? "a closed " : "a ", kind_of(p), " has ", points.size(), " points; it must have at least ",
           least);
  for (size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) refuse("point ", i, " of a ", kind_of(p), " is not finite");
  }
  for (size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const size_t before = (i ? i : points.size()) - 1;
    if (!(length(points[i] - points[before]) > 1e-6f * max_component(abs(points[i]))))
      refuse("points ", before, " and ", i, " of a ", kind_of(p), " coincide");
  }
}

/// The properties of a rod per metre.
struct Section {
  float mass;            // kg/m
  float stretch, shear;  // N
  float bend, twist;     // N·m²
  float squared_radius;  // m²
};

Section section_of(const RodParameters& p) {
  // Timoshenko's shear coefficient of a round section
  constexpr float shear_coefficient = 0.9f;
  const float r2 = p.radius * p.radius, area = pi * r2;
  const float stretch = p.stretch_stiffness.value_or(p.youngs_modulus * area);
  // Shear stiffness scales with the stretch stiffness.
  const float shear =
      std::isinf(p.youngs_modulus) ? p.shear_modulus * area : stretch * (p.shear_modulus / p.youngs_modulus);
  return {p.density * area,
          stretch,
          shear_coefficient * shear,
          p.bending_stiffness.value_or(0.25f * p.youngs_modulus * area * r2),
          p.twist_stiffness.value_or(0.5f * p.shear_modulus * area * r2),
          r2};
}

/// The smallest rotation that takes the unit vector `from` to `to`.
Quat least_turn(Vec3 from, Vec3 to) {
  const float w = 1 + dot(from, to);
  if (w > 1e-6f) {
    const Vec3 v = cross(from, to);
    return normalized(Quat{v.x, v.y, v.z, w});
  }
  const Vec3 aside = std::fabs(from.x) < 0.5f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 axis = normalized_or(cross(from, aside), {0, 0, 1});
  return {axis.x, axis.y, axis.z, 0};
}

/// The part of a rotation that is about the z axis.
Quat twist_of(Quat q) {
  const float norm = std::hypot(q.z, q.w);
  return norm > 1e-6f ? Quat{0, 0, q.z / norm, q.w / norm} : Quat{0, 0, 0, 1};
}

/// The inertia of a slice of the rod is that of its section. About an axis across it, a long thin segment has
/// at least the inertia of its mass along it. About its own axis it has at least a hundredth of that. Were
/// frames much lighter than vertices, floats could not resolve the contribution of the vertices.
void set_mobility(RodSegment& s, const Section& section) {
  const float l = s.rest_length, mass = section.mass * l;
  const float across = std::max(0.25f * mass * section.squared_radius, mass * l * l / 24);
  s.bend_mobility = 1 / across;
  s.twist_mobility =
      1 / std::max(0.5f * mass * section.squared_radius, rod_tuning::least_axial_inertia * across);
}

RodSegment make_segment(uint32_t a, uint32_t b, float rest_length, const Section& section, float damping) {
  RodSegment s{};
  s.a = a;
  s.b = b;
  s.rest_length = rest_length;
  s.stretch_compliance = rest_length / section.stretch;
  s.shear_compliance = rest_length / section.shear;
  s.bend_compliance = 0.5f * rest_length / section.bend;
  s.twist_compliance = 0.5f * rest_length / section.twist;
  s.damping = damping;
  s.rest = {0, 0, 0, 1};
  set_mobility(s, section);
  return s;
}

void join(std::vector<RodSegment>& segments, bool closed) {
  const auto count = static_cast<uint32_t>(segments.size());
  for (uint32_t k = 0; k < count; ++k) {
    segments[k].before = k ? k - 1 : closed ? count - 1 : pbd::no_index;
    segments[k].after = k + 1 < count ? k + 1 : closed ? 0 : pbd::no_index;
  }
}

/// Each frame is the one before it, rotated only as far as the rod bends.
std::vector<Quat> carried_frames(std::span<const Vec3> points, std::span<const RodSegment> segments) {
  std::vector<Quat> frames;
  Vec3 along{0, 0, 1};
  Quat frame{0, 0, 0, 1};
  for (const RodSegment& s : segments) {
    const Vec3 next = normalized_or(points[s.b] - points[s.a], along);
    frame = normalized(least_turn(along, next) * frame);
    frames.push_back(frame);
    along = next;
  }
  return frames;
}

void set_rest(RodModel& model, bool straight) {
  for (size_t k = 0; k < model.segments.size(); ++k) {
    RodSegment& s = model.segments[k];
    if (s.after == pbd::no_index) continue;
    const Quat relative = conjugate(model.frames[k]) * model.frames[s.after];
    // Around a loop in space, frames return rotated. That rotation is no twist.
    s.rest = straight ? twist_of(relative) : normalized(relative);
  }
}

}  // namespace

RodModel build_rod(std::span<const Vec3> points, const RodParameters& parameters) {
  check(parameters);
  check(points, parameters);
  const Section section = section_of(parameters);
  const auto count = static_cast<uint32_t>(points.size());
  const uint32_t segments = parameters.closed ? count : count - 1;

  RodModel model;
  model.chains = {{0, segments, parameters.closed ? 1u : 0u}};
  model.masses.assign(count, 0);
  for (uint32_t k = 0; k < segments; ++k) {
    const uint32_t a = k, b = (k + 1) % count;
    const float l = length(points[b] - points[a]);
    model.segments.push_back(make_segment(a, b, l, section, parameters.damping));
    for (uint32_t v : {a, b}) model.masses[v] += 0.5f * section.mass * l;
  }
  join(model.segments, parameters.closed);
  if (parameters.bends_and_twists) {
    model.frames = carried_frames(points, model.segments);
    set_rest(model, parameters.straight_at_rest);
  }
  return model;
}

Quat turned_frame(Quat frame, Vec3 segment) {
  const Vec3 along = rotate(frame, {0, 0, 1});
  return normalized(least_turn(along, normalized_or(segment, along)) * frame);
}

void append(RodModel& model, const RodModel& more, uint32_t first_vertex) {
  const uint32_t first = model.segment_count();
  for (RodChain chain : more.chains) {
    chain.first += first;
    model.chains.push_back(chain);
  }
  for (RodSegment s : more.segments) {
    s.a += first_vertex;
    s.b += first_vertex;
    if (s.before != pbd::no_index) s.before += first;
    if (s.after != pbd::no_index) s.after += first;
    model.segments.push_back(s);
  }
  model.frames.insert(model.frames.end(), more.frames.begin(), more.frames.end());
  model.masses.insert(model.masses.end(), more.masses.begin(), more.masses.end());
}

}  // namespace meniscus::cloth
