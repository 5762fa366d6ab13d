// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Linearizes the constraints of a rod, segment by segment.
#pragma once

#include "cloth/rods/rod_view.h"
#include "cloth/rods/tuning.h"

namespace meniscus::cloth::rod_kernels {

/// Writes the contribution of segment k to the equations of the increments,
///
///   (J W Jᵀ + α̃/(1 + γ)) Δλ = −(C + α̃ λ + γ (C − C₀))/(1 + γ),  α̃ = α/h²,  γ = damping/h
///
/// (Macklin, Müller & Chentanez 2016, eqs. 18 and 26). Multipliers of stretch are in the world's axes. Those
/// of bending are in the axes of the joint. A block off the diagonal is written by the segment that both of
/// its constraints share.
struct Linearize {
  RodView rods;

  MENISCUS_HD void operator()(uint32_t k) const {
    const Segment s = segment(k);
    stretch_and_shear(s);
    const Mat3 before = s.data.before == pbd::no_index ? Mat3{} : joint_before(s);
    rods.link[k] = {s.reach, s.data.after == pbd::no_index ? Mat3{} : joint_after(s, before)};
  }

 private:
  struct Segment {
    uint32_t index;
    RodSegment data;
    Quat frame;
    Mat3 axes;
    Vec3 mobility, reach;  // in its axes
    float freedom;         // 0 if it is held
    float mass;            // 1/kg, inverse, of both vertices
    float mass_b;          // 1/kg, inverse, of the second
    Mat3 gradient;         // of stretch, by a rotation of the frame
  };

  MENISCUS_HD Segment segment(uint32_t k) const {
    const RodSegment data = rods.segment[k];
    const uint32_t first = rods.particles.sorted;
    const Vec4 a = rods.particles.position[first + data.a], b = rods.particles.position[first + data.b];
    const Quat frame = quat(rods.frame[k]);
    const Mat3 axes = rotation_matrix(frame);
    const Vec3 reach = transposed_times(axes, b.xyz() - a.xyz());
    return {k,     data,           frame,     axes, mobility(rods, k),
            reach, rods.spin[k].w, a.w + b.w, b.w,  axes * cross_matrix(reach, 0)};
  }

  MENISCUS_HD void stretch_and_shear(const Segment& s) const {
    const float damping = s.data.damping / rods.dt;
    const Vec3 compliance =
        inverse_dt2() * Vec3{s.data.shear_compliance, s.data.shear_compliance, s.data.stretch_compliance};
    const Mat3 lever = cross_matrix(s.reach, 0);
    Sym3 local = symmetric_product(times_diagonal(lever, s.mobility), lever);
    add_to_diagonal(local, Vec3{s.mass, s.mass, s.mass} + compliance / (1 + damping));
    BandRow& row = rods.rows[2 * s.index];
    row.diagonal = turned(s.axes, local);
    row.after = {{-s.mass_b, 0, 0}, {0, -s.mass_b, 0}, {0, 0, -s.mass_b}};
    row.right =
        s.axes * right_side(stretch_strain(s.reach, s.data.rest_length), rods.start[s.index].stretch,
                            compliance, transposed_times(s.axes, rods.multiplier[s.index].stretch), damping);
  }

  /// Returns the gradient of the joint's bending by a rotation of s, times the mobility.
  MENISCUS_HD Mat3 joint_before(const Segment& s) const {
    const Quat rest = rods.segment[s.data.before].rest;
    const Quat p = relative_frame(quat(rods.frame[s.data.before]), s.frame, rest);
    const Mat3 before = times_diagonal(joint_of(p).gradient, s.mobility);
    rods.rows[2 * s.data.before + 1].next = times_transposed(s.gradient, before);
    return before;
  }

  /// Returns the gradient of the joint's bending by a rotation of the next frame.
  MENISCUS_HD Mat3 joint_after(const Segment& s, const Mat3& before) const {
    const RodSegment t = rods.segment[s.data.after];
    const float free_behind = rods.spin[s.data.after].w;
    const Quat p = relative_frame(s.frame, quat(rods.frame[s.data.after]), s.data.rest);
    const Joint joint = joint_of(p);
    const Mat3 g1 = joint.gradient, g0 = minus_transposed(g1);
    const Mat3 g0w = times_diagonal(g0, s.mobility), g1w = times_diagonal(g1, mobility(rods, s.data.after));
    rods.rows[2 * s.index].next = times_transposed(g0w, s.gradient);
    if (s.data.before != pbd::no_index) rods.rows[2 * s.data.before + 1].after = times_transposed(g0, before);

    const float damping = s.data.damping / rods.dt;
    const float bend = s.freedom * s.data.bend_compliance + free_behind * t.bend_compliance;
    const float twist = s.freedom * s.data.twist_compliance + free_behind * t.twist_compliance;
    const Vec3 compliance = inverse_dt2() * Vec3{bend, bend, twist};
    BandRow& row = rods.rows[2 * s.index + 1];
    row.diagonal = symmetric_product(g0w, g0) + symmetric_product(g1w, g1);
    add_to_diagonal(row.diagonal, compliance / (1 + damping));
    row.right = {0, 0, 0};  // two held segments have no joint between them
    if (s.freedom + free_behind > 0) {
      row.right = right_side(joint.bend - rotation_vector(s.data.rest), rods.start[s.index].bend, compliance,
                             rods.multiplier[s.index].bend, damping);
    }
    return g1;
  }

  MENISCUS_HD float inverse_dt2() const { return 1 / (rods.dt * rods.dt); }

  MENISCUS_HD static void add_to_diagonal(Sym3& m, Vec3 added) {
    m.xx = regularised(m.xx + added.x);
    m.yy = regularised(m.yy + added.y);
    m.zz = regularised(m.zz + added.z);
  }
  /// Where nothing may move there is no equation, and any Δλ does no harm.
  MENISCUS_HD static float regularised(float m) { return m > 0 ? (1 + rod_tuning::regularisation) * m : 1; }

  MENISCUS_HD static Vec3 right_side(Vec3 strain, Vec3 start, Vec3 compliance, Vec3 multiplier,
                                     float damping) {
    const Vec3 yielded{compliance.x * multiplier.x, compliance.y * multiplier.y, compliance.z * multiplier.z};
    return -(strain + yielded + damping * (strain - start)) / (1 + damping);
  }
};

}  // namespace meniscus::cloth::rod_kernels
