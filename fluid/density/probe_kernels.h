// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that sum up what probes measure.
#pragma once

#include "fluid/density/probes.h"
#include "pbd/device/base/atomics.h"

namespace meniscus::fluid {

namespace probe_kernels {

/// Of a column. Higher ones end there.
inline constexpr uint32_t most_layers = 4096;

/// The kernel-weighted mean of the particles' pressures Λ / (V h_t²) around a point.
template <class K>
struct PointPressure {
  K kernel;
  pbd::View<const pbd::Vec4> position;
  pbd::View<const density_kernels::Multiplier> multiplier;
  pbd::View<const pbd::Phase> phase;
  pbd::PeriodicAxes axes;
  Vec3 point;
  float to_pressure;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    if (pbd::is_grain(phase[i])) return {};
    const Vec3 d = axes.nearest(position[i].xyz() - point);
    const double weight = kernel.weight(dot(d, d));
    return {weight * (to_pressure * multiplier[i].value), weight, 0, 0, 0};
  }
};

MENISCUS_HD inline ProbeSum vector_sum(Vec3 v, double weight) {
  return {0, weight, v.x, v.y, v.z};
}

/// The same of their velocities.
template <class K>
struct PointVelocity {
  K kernel;
  pbd::View<const pbd::Vec4> position, velocity;
  pbd::PeriodicAxes axes;
  Vec3 point;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    const Vec3 d = axes.nearest(position[i].xyz() - point);
    const float weight = kernel.weight(dot(d, d));
    return vector_sum(weight * velocity[i].xyz(), weight);
  }
};

/// The density around a point: Σ m/s³ V W. The kernel's volume V makes it the rest density on the lattice.
template <class K>
struct PointDensity {
  K kernel;
  pbd::View<const pbd::Vec4> position;
  pbd::PeriodicAxes axes;
  Vec3 point;
  float particle_volume;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    const pbd::Vec4 p = position[i];
    const Vec3 d = axes.nearest(p.xyz() - point);
    return {double{kernel.weight(dot(d, d))} / (double{particle_volume} * p.w), 0, 0, 0, 0};
  }
};

/// The force on one fixed shape through the contacts of particle i, or its torque about a point.
struct WallForce {
  pbd::ContactView contacts;
  uint32_t shape;
  Aabb patch;
  float to_force;  ///< 1/h_t²
  bool torque;
  Vec3 point;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    ProbeSum total{};
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& c = contacts.contacts[k];
      if (c.solid != shape || c.body != pbd::no_index || !inside(patch, c.point)) continue;
      const Vec3 force = -to_force * multiplier_sum(c);
      const Vec3 f = torque ? cross(c.point - point, force) : force;
      total.x += f.x;
      total.y += f.y;
      total.z += f.z;
    }
    return total;
  }
};

/// The flow through a disc: the mean over layers of one spacing on both sides of it.
struct DiscFlow {
  pbd::View<const pbd::Vec4> position, velocity;
  pbd::PeriodicAxes axes;
  Vec3 point, normal;
  float radius, spacing;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    const Vec3 d = axes.nearest(position[i].xyz() - point);
    const float along = dot(d, normal);
    const Vec3 beside = d - along * normal;
    if (fabsf(along) > spacing || dot(beside, beside) > radius * radius) return {};
    const float area = spacing * spacing;  // s³ over the thickness of the layers, 2 s
    return {0.5 * double{area} * dot(velocity[i].xyz(), normal), 0, 0, 0, 0};
  }
};

/// The momentum of a fluid, its angular momentum about a point, or its mass times the place of its centre.
struct FluidSum {
  ProbeMeasure measure;
  pbd::View<const pbd::Vec4> position, velocity;
  pbd::View<const pbd::Phase> phase;
  uint32_t group;
  Vec3 point;

  MENISCUS_HD ProbeSum operator()(uint32_t i) const {
    if (group != pbd::no_index && pbd::phase_group(phase[i]) != group) return {};
    const pbd::Vec4 p = position[i];
    const float mass = 1 / p.w;
    const Vec3 v = velocity[i].xyz();
    if (measure == ProbeMeasure::centre) return vector_sum(mass * p.xyz(), mass);
    return vector_sum(mass * (measure == ProbeMeasure::momentum ? v : cross(p.xyz() - point, v)), 0);
  }
};

/// Counts the particles of a column in layers of one spacing.
struct CountLayers {
  pbd::View<const pbd::Vec4> position;
  pbd::PeriodicAxes axes;
  Vec3 point, normal;
  float radius, spacing;
  pbd::View<uint32_t> layers;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 d = axes.nearest(position[i].xyz() - point);
    const float along = dot(d, normal);
    const Vec3 beside = d - along * normal;
    if (!(along >= 0) || dot(beside, beside) > radius * radius) return;
    const float layer = along / spacing;
    if (layer < static_cast<float>(layers.count)) pbd::atomic_add(layers[static_cast<uint32_t>(layer)], 1u);
  }
};

/// The level: full layers from the foot up, and what is in the two on top. A layer is full where it has what
/// the layers below have on average. The first layer with less than half ends the pool.
struct FindLevel {
  pbd::View<const uint32_t> layers;
  float full;  ///< particles, of a layer of the column at rest
  float spacing;
  pbd::View<ProbeSum> value;

  MENISCUS_HD void operator()(uint32_t) const {
    uint32_t pool = 0, below = 0;  // layers of the pool, and particles in all of them but the topmost
    double mean = full, last = 0;
    while (pool < layers.count && layers[pool] >= 0.5 * mean) {
      below += pool > 0 ? static_cast<uint32_t>(last) : 0;
      last = layers[pool++];
      if (pool > 2) mean = static_cast<double>(below) / (pool - 1);
    }
    const auto part = [&](double count) { return count < mean ? count / mean : 1.0; };
    const double above = pool < layers.count ? layers[pool] : 0;
    const double height = pool > 0 ? pool - 1 + part(last) + part(above) : part(above);
    value[0] = {spacing * height, 0, 0, 0, 0};
  }
};

struct Add {
  MENISCUS_HD ProbeSum operator()(const ProbeSum& a, const ProbeSum& b) const {
    return {a.value + b.value, a.weight + b.weight, a.x + b.x, a.y + b.y, a.z + b.z};
  }
};

struct Accumulate {
  pbd::View<const ProbeSum> value;
  pbd::View<ProbeSum> totals;
  uint32_t probe;

  MENISCUS_HD void operator()(uint32_t) const { totals[probe] = Add{}(totals[probe], value[0]); }
};

}  // namespace probe_kernels

}  // namespace meniscus::fluid
