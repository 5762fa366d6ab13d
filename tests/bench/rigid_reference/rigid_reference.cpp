// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Compares candidates for the contacts of solids on stacks, a pyramid, mass ratios and a fall. Prints the
// table of docs/methods/rigid-contacts.md.
#include <chrono>
#include <cstdio>

#include "tests/bench/rigid_reference/block_descent.h"
#include "tests/bench/rigid_reference/soft_tgs.h"
#include "tests/bench/rigid_reference/xpbd.h"

namespace meniscus::rigid_reference {

namespace {

constexpr float half = 0.05f, dt = 1.0f / 240;

std::vector<Body> ground() {
  return {box({5, 1, 5}, {0, -1, 0}, 0)};
}

std::vector<Body> stack() {
  std::vector<Body> bodies = ground();
  for (int k = 0; k < 10; ++k)
    bodies.push_back(box({half, half, half}, {0, half * (2.0f * static_cast<float>(k) + 1), 0}, 1000));
  return bodies;
}

std::vector<Body> pyramid() {
  std::vector<Body> bodies = ground();
  for (int row = 0; row < 10; ++row) {
    for (int k = 0; k < 10 - row; ++k) {
      const float x = 2.1f * half * (static_cast<float>(k) + 0.5f * static_cast<float>(row));
      bodies.push_back(box({half, half, half}, {x, half * (2.0f * static_cast<float>(row) + 1), 0}, 1000));
    }
  }
  return bodies;
}

/// A light plate on four light feet, with a load of `ratio` times the mass of the plate.
std::vector<Body> loaded(float ratio) {
  std::vector<Body> bodies = ground();
  for (const float x : {-0.2f, 0.2f})
    for (const float z : {-0.2f, 0.2f}) bodies.push_back(box({half, half, half}, {x, half, z}, 100));
  bodies.push_back(box({0.3f, 0.02f, 0.3f}, {0, 2 * half + 0.02f, 0}, 100));
  const float plate = 100 * 8 * 0.3f * 0.02f * 0.3f;
  bodies.push_back(box({0.1f, 0.1f, 0.1f}, {0, 2 * half + 0.04f + 0.1f, 0}, ratio * plate / 0.008f));
  return bodies;
}

/// Boxes that fall on one another.
std::vector<Body> heap() {
  std::vector<Body> bodies = ground();
  for (int k = 0; k < 40; ++k) {
    const float x = 0.12f * static_cast<float>(k % 2), z = 0.12f * static_cast<float>(k / 2 % 2);
    bodies.push_back(box({half, half, half}, {x, 0.08f + 0.14f * static_cast<float>(k / 4), z}, 1000));
    turn(bodies.back(), {0.4f * static_cast<float>(k % 3), 0.3f, 0.2f * static_cast<float>(k % 5)});
  }
  return bodies;
}

struct Outcome {
  float sunk = 0, crept = 0;       ///< m: by the highest body; the most of any, sideways, in the last half
  float speed = 0, top_speed = 0;  ///< m/s at the end, RMS; the most of any in the last half
  float microseconds = 0;
};

template <class Solver>
Outcome run(std::vector<Body> bodies, Solver solver, int effort, float seconds) {
  Outcome out;
  const std::vector<Body> start = bodies;
  std::vector<Body> middle;
  const int steps = static_cast<int>(seconds / dt);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) middle = bodies;
    solver.step(bodies, dt, effort);
    for (const Body& b : bodies)
      if (i >= steps / 2) out.top_speed = std::max(out.top_speed, length(b.velocity));
  }
  const std::chrono::duration<float> took = std::chrono::steady_clock::now() - begin;
  out.microseconds = 1e6f * took.count() / static_cast<float>(steps);
  out.sunk = start.back().pose.position.y - bodies.back().pose.position.y;
  for (size_t k = 0; k < bodies.size(); ++k) {
    Vec3 way = bodies[k].pose.position - middle[k].pose.position;
    way.y = 0;
    out.crept = std::max(out.crept, length(way));
    out.speed += dot(bodies[k].velocity, bodies[k].velocity) / static_cast<float>(bodies.size() - 1);
  }
  out.speed = std::sqrt(out.speed);
  return out;
}

template <class Solver>
void compare(const char* name, int effort, float seconds) {
  const auto print = [&](const char* scene, const std::vector<Body>& bodies) {
    const Outcome o = run(bodies, Solver(), effort, seconds);
    std::printf("| %s, %d | %s | %.3g | %.3g | %.2g | %.2g | %.0f |\n", name, effort, scene, 1e3f * o.sunk,
                1e3f * o.crept, o.speed, o.top_speed, o.microseconds);
  };
  print("stack of 10", stack());
  print("pyramid of 55", pyramid());
  print("load, 30 ×", loaded(30));
  print("load, 300 ×", loaded(300));
  print("heap of 40", heap());
}

}  // namespace

}  // namespace meniscus::rigid_reference

/// The effort is how often each contact is visited in a step of 1/240 s.
int main(int, char** arguments) {
  using namespace meniscus::rigid_reference;
  const float seconds = arguments[1] ? std::strtof(arguments[1], nullptr) : 10;
  std::puts("| solver, effort | scene | sunk, mm | crept, mm | speed, m/s | most, m/s | µs a step |");
  std::puts("|---|---|---|---|---|---|---|");
  for (const int effort : {8, 16, 32}) {
    compare<Xpbd>("XPBD", effort, seconds);
    compare<SoftTgs>("soft TGS", effort, seconds);
    compare<BlockDescent>("AVBD", effort, seconds);
  }
}
