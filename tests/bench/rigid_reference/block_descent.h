// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Augmented vertex block descent (Giles, Diaz & Yuksel 2025): body after body, a step of Newton's method on
// its six coordinates, with multipliers and growing penalties on contacts.
#pragma once

#include "tests/bench/rigid_reference/bodies.h"

namespace meniscus::rigid_reference {

class BlockDescent {
 public:
  float alpha = 0.99f, beta = 1e5f, gamma = 0.99f;  ///< as the authors'
  float least_penalty = 1, most_penalty = 1e9f;

  void step(std::vector<Body>& bodies, float dt, int iterations) {
    rows_ = find(bodies, rows_);
    touching_.assign(bodies.size(), {});
    for (uint32_t k = 0; k < rows_.size(); ++k) {
      touching_[rows_[k].a].push_back(k);
      touching_[rows_[k].b].push_back(k);
      for (int i = 0; i < 3; ++i) {
        rows_[k].impulse[i] *= alpha * gamma;
        rows_[k].penalty[i] = std::clamp(gamma * rows_[k].penalty[i], least_penalty, most_penalty);
      }
    }
    start(bodies, dt);
    for (int i = 0; i <= iterations; ++i) {  // the last one removes overlaps, and gives no velocity
      kept_ = i < iterations ? alpha : 0;
      for (uint32_t k = 0; k < bodies.size(); ++k)
        if (bodies[k].inverse_mass > 0) descend(bodies, k, dt);
      if (i < iterations)
        for (Row& r : rows_) raise(bodies[r.a], bodies[r.b], r);
      if (i == iterations - 1) {
        for (Body& b : bodies) {
          if (b.inverse_mass == 0) continue;
          b.velocity = b.moved / dt;
          b.angular = b.turned / dt;
        }
      }
    }
    for (Body& b : bodies) {
      b.pose.position += b.moved;
      turn(b, b.turned);
    }
  }

 private:
  /// Where bodies would be without contacts, and where to start: with the acceleration of the last step.
  void start(std::vector<Body>& bodies, float dt) {
    inertial_.resize(bodies.size());
    last_velocity_.resize(bodies.size(), {0, 0, 0});
    for (size_t k = 0; k < bodies.size(); ++k) {
      Body& b = bodies[k];
      if (b.inverse_mass == 0) continue;
      const float fall = (last_velocity_[k].y - b.velocity.y) / (dt * gravity);
      last_velocity_[k] = b.velocity;
      inertial_[k] = {dt * b.velocity - Vec3{0, dt * dt * gravity, 0}, dt * b.angular};
      b.moved = dt * b.velocity - Vec3{0, dt * dt * gravity * std::clamp(fall, 0.0f, 1.0f), 0};
      b.turned = inertial_[k].turned;
    }
  }

  struct Forces {
    float value[3];
    float violation[3];
  };
  Forces forces(const Body& a, const Body& b, const Row& r) const {
    const Vec3 way = way_of(a, b, r), d[3] = {r.normal, r.along, r.across};
    Forces f;
    for (int i = 0; i < 3; ++i) {
      f.violation[i] = dot(way, d[i]) +
                       (i == 0 ? (1 - kept_) * std::min(r.distance, 0.0f) + std::max(r.distance, 0.0f) : 0);
      f.value[i] = r.penalty[i] * f.violation[i] + r.impulse[i];
    }
    f.value[0] = std::min(f.value[0], 0.0f);
    const float size = std::hypot(f.value[1], f.value[2]), most = -friction * f.value[0];
    if (size > most)
      for (int i = 1; i < 3; ++i) f.value[i] *= most / size;
    return f;
  }

  void raise(const Body& a, const Body& b, Row& r) {
    const Forces f = forces(a, b, r);
    std::copy_n(f.value, 3, r.impulse);
    if (f.value[0] < 0)
      r.penalty[0] = std::min(r.penalty[0] + beta * std::fabs(f.violation[0]), most_penalty);
    if (std::hypot(f.value[1], f.value[2]) < -friction * f.value[0])
      for (int i = 1; i < 3; ++i)
        r.penalty[i] = std::min(r.penalty[i] + beta * std::fabs(f.violation[i]), most_penalty);
  }

  /// Solves the six equations of a body by Cholesky's factors.
  void descend(std::vector<Body>& bodies, uint32_t k, float dt) {
    Body& body = bodies[k];
    float h[6][6] = {}, g[6];
    const float m = 1 / (body.inverse_mass * dt * dt);
    const Vec3 p = body.moved - inertial_[k].moved, q = body.turned - inertial_[k].turned;
    const Vec3 e[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Vec3 spin{0, 0, 0};
    for (int i = 0; i < 3; ++i) {  // the inertia in world axes
      const Vec3 axis = rotate(body.pose.rotation, e[i]);
      const float inertia = 1 / (collision::component(body.inverse_inertia, i) * dt * dt);
      spin += inertia * dot(axis, q) * axis;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          h[3 + r][3 + c] += inertia * collision::component(axis, r) * collision::component(axis, c);
      h[i][i] = m;
    }
    for (int i = 0; i < 3; ++i) {
      g[i] = m * collision::component(p, i);
      g[3 + i] = collision::component(spin, i);
    }
    for (const uint32_t n : touching_[k]) {
      const Row& r = rows_[n];
      const Forces f = forces(bodies[r.a], bodies[r.b], r);
      const float side = r.a == k ? 1.0f : -1.0f;
      const Vec3 arm = r.a == k ? r.arm_a : r.arm_b, d[3] = {r.normal, r.along, r.across};
      for (int i = 0; i < 3; ++i) {
        const Vec3 c = cross(arm, d[i]);
        const float j[6] = {side * d[i].x, side * d[i].y, side * d[i].z, side * c.x, side * c.y, side * c.z};
        for (int row = 0; row < 6; ++row) {
          g[row] += j[row] * f.value[i];
          for (int col = 0; col < 6; ++col) h[row][col] += r.penalty[i] * j[row] * j[col];
        }
      }
    }
    solve(h, g);
    body.moved -= {g[0], g[1], g[2]};
    body.turned -= {g[3], g[4], g[5]};
  }

  static void solve(float (&h)[6][6], float (&g)[6]) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j <= i; ++j) {
        float s = h[i][j];
        for (int k = 0; k < j; ++k) s -= h[i][k] * h[j][k];
        h[i][j] = i == j ? std::sqrt(std::max(s, 1e-20f)) : s / h[j][j];
      }
    }
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < i; ++k) g[i] -= h[i][k] * g[k];
      g[i] /= h[i][i];
    }
    for (int i = 5; i >= 0; --i) {
      for (int k = i + 1; k < 6; ++k) g[i] -= h[k][i] * g[k];
      g[i] /= h[i][i];
    }
  }

  struct Place {
    Vec3 moved, turned;
  };
  std::vector<Row> rows_;
  std::vector<std::vector<uint32_t>> touching_;
  std::vector<Place> inertial_;
  std::vector<Vec3> last_velocity_;
  float kept_ = 0;
};

}  // namespace meniscus::rigid_reference
