// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each number that a call takes outside of a definition: where it is not finite or out of its range, it is
// refused by its name, and the world is as before. Where it is huge, the world refuses it or stays finite.
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "tests/unit/sdk/world/misuse/misuse_world.h"

namespace meniscus::tests {
namespace {

/// A number that a call takes. It may be any finite one, unless `wrong` says what it may not be.
struct Argument {
  const char* name;  ///< as the error has it
  std::function<void(MisuseWorld&, float)> call;
  std::vector<float> wrong{};
};

const Quat turn{0, 0, 0, 1};

const std::vector<ParticleId> two_particles{3, 5};
const std::vector<uint32_t> two_vertices{1, 2};

std::vector<Vec3> two(float x) {
  return {{0, 0, 0}, {0, x, 0}};
}

std::vector<Vec3> spoiled(std::span<const Vec3> values, float x) {
  std::vector<Vec3> changed(values.begin(), values.end());
  changed.back().y = x;
  return changed;
}

/// For each particle, all but the last of them where they are.
std::vector<Vec3> all_at(const MisuseWorld& w, float x) {
  return spoiled(w.world.positions(), x);
}

std::vector<Argument> arguments() {
  using W = MisuseWorld;
  const std::vector<float> not_positive{0, -1};
  return {
      {"a position of add_particles",
       [](W& w, float x) {
         w.world.add_particles(w.water, std::vector<Vec3>{{0, 2, 0}, {0, x, 0}});
       }},
      {"a velocity of add_particles",
       [](W& w, float x) {
         w.world.add_particles(w.water, std::vector<Vec3>{{0, 2, 0}, {0.1f, 2, 0}}, two(x));
       }},
      {"an impulse of apply_impulses", [](W& w, float x) { w.world.apply_impulses(two_particles, two(x)); }},
      {"an impulse of apply_impulses",
       [](W& w, float x) { w.world.apply_impulses(w.cloth, two_vertices, two(x)); }},
      {"an impulse of apply_impulses",
       [](W& w, float x) { w.world.apply_impulses(w.string, two_vertices, two(x)); }},
      {"a position of set_positions", [](W& w, float x) { w.world.set_positions(two_particles, two(x)); }},
      {"a position of set_positions", [](W& w, float x) { w.world.set_positions(all_at(w, x)); }},
      {"a position of set_positions", [](W& w, float x) { w.world.set_positions(w.water, all_at(w, x)); }},
      {"a velocity of set_velocities", [](W& w, float x) { w.world.set_velocities(two_particles, two(x)); }},
      {"a velocity of set_velocities", [](W& w, float x) { w.world.set_velocities(all_at(w, x)); }},
      {"a velocity of set_velocities", [](W& w, float x) { w.world.set_velocities(w.water, all_at(w, x)); }},
      {"a position of set_cloth_positions",
       [](W& w, float x) {
         w.world.set_cloth_positions(w.cloth, spoiled(w.world.cloth_positions(w.cloth), x));
       }},
      {"a velocity of set_cloth_velocities",
       [](W& w, float x) {
         w.world.set_cloth_velocities(w.cloth, spoiled(w.world.cloth_velocities(w.cloth), x));
       }},
      {"a position of set_rope_positions",
       [](W& w, float x) {
         w.world.set_rope_positions(w.string, spoiled(w.world.rope_positions(w.string), x));
       }},
      {"a velocity of set_rope_velocities",
       [](W& w, float x) {
         w.world.set_rope_velocities(w.string, spoiled(w.world.rope_velocities(w.string), x));
       }},
      {"set_shape_pose's pose.position",
       [](W& w, float x) {
         w.world.set_shape_pose(w.vessel, {{x, 0, 0}, turn});
       }},
      {"set_shape_pose's pose.rotation",
       [](W& w, float x) {
         w.world.set_shape_pose(w.vessel, {{0, 0, 0}, {0, x, 0, 0}});
       },
       {0, 2}},
      {"SurfaceDef::friction", [](W& w, float x) { w.world.set_surface(w.vessel, {.friction = x}); }, {-1}},
      {"SurfaceDef::friction", [](W& w, float x) { w.world.set_surface(w.box, {.friction = x}); }, {-1}},
      {"step's dt", [](W& w, float x) { w.world.step(x); }, {0, -1, 1e-13f}},
      {"set_body_pose's pose.position",
       [](W& w, float x) {
         w.world.set_body_pose(w.box, {{x, 0, 0}, turn});
       }},
      {"set_body_pose's pose.rotation",
       [](W& w, float x) {
         w.world.set_body_pose(w.box, {{0, 1, 0}, {x, 0, 0, 0}});
       },
       {0, 2}},
      {"set_body_velocity's velocity",
       [](W& w, float x) {
         w.world.set_body_velocity(w.box, {x, 0, 0}, {});
       }},
      {"set_body_velocity's angular_velocity",
       [](W& w, float x) {
         w.world.set_body_velocity(w.box, {}, {0, x, 0});
       }},
      {"apply_force's force",
       [](W& w, float x) {
         w.world.apply_force(w.box, {0, 0, x}, {});
       }},
      {"apply_force's point",
       [](W& w, float x) {
         w.world.apply_force(w.box, {1, 0, 0}, {0, x, 0});
       }},
      {"apply_torque's torque",
       [](W& w, float x) {
         w.world.apply_torque(w.box, {0, x, 0});
       }},
      {"apply_impulse's impulse",
       [](W& w, float x) {
         w.world.apply_impulse(w.box, {0, x, 0}, {});
       }},
      {"apply_impulse's point",
       [](W& w, float x) {
         w.world.apply_impulse(w.box, {1, 0, 0}, {0, x, 0});
       }},
      {"move_body's target.position",
       [](W& w, float x) {
         w.world.move_body(w.door, {{x, 0, 0}, turn}, 1);
       }},
      {"move_body's target.rotation",
       [](W& w, float x) {
         w.world.move_body(w.door, {{0, 1, 0}, {0, 0, 0, x}}, 1);
       },
       {0, 2}},
      {"move_body's duration",
       [](W& w, float x) {
         w.world.move_body(w.door, {{0, 1, 0}, turn}, x);
       },
       not_positive},
      {"cast_ray's from",
       [](W& w, float x) {
         w.world.cast_ray({x, 0, 0}, {0, 1, 0});
       }},
      {"cast_ray's to",
       [](W& w, float x) {
         w.world.cast_ray({0, 1, 0}, {0, x, 0});
       }},
      {"a point of solid_distances", [](W& w, float x) { w.world.solid_distances(two(x), 1); }},
      {"solid_distances's reach", [](W& w, float x) { w.world.solid_distances(two(1), x); }, not_positive},
      {"overlap_ball's centre",
       [](W& w, float x) {
         w.world.overlap_ball({0, x, 0}, 1);
       }},
      {"overlap_ball's radius",
       [](W& w, float x) {
         w.world.overlap_ball({0, 0, 0}, x);
       },
       not_positive},
      {"overlap_box's pose.position",
       [](W& w, float x) {
         w.world.overlap_box({{0, x, 0}, turn}, {1, 1, 1});
       }},
      {"overlap_box's pose.rotation",
       [](W& w, float x) {
         w.world.overlap_box({{0, 0, 0}, {x, 0, 0, 0}}, {1, 1, 1});
       },
       {0, 2}},
      {"overlap_box's half_extents",
       [](W& w, float x) {
         w.world.overlap_box({}, {1, x, 1});
       },
       not_positive},
  };
}

class MisuseArgumentsTest : public OnDevice {};

TEST_P(MisuseArgumentsTest, ANumberOutOfItsRangeIsRefusedByName) {
  MisuseWorld w(GetParam());
  const Sight before(w);
  for (const Argument& argument : arguments()) {
    std::vector<float> wrong = argument.wrong;
    for (const float x : {not_a_number, infinity, -infinity}) wrong.push_back(x);
    for (const float x : wrong) {
      SCOPED_TRACE(std::string(argument.name) + " = " + std::to_string(x));
      expect_error(ErrorCode::invalid_argument, argument.name, [&] { argument.call(w, x); });
      EXPECT_TRUE(Sight(w) == before);
    }
  }
  for (const int wrong : {-1, 100001}) {
    expect_error(ErrorCode::invalid_argument, "relax's iterations", [&] { w.world.relax(wrong); });
    EXPECT_TRUE(Sight(w) == before);
  }
}

TEST_P(MisuseArgumentsTest, AHugeNumberIsRefusedOrTheWorldStaysFinite) {
  for (const Argument& argument : arguments()) {
    for (const float x : {1e12f, -1e12f, std::numeric_limits<float>::max()}) {
      SCOPED_TRACE(std::string(argument.name) + " = " + std::to_string(x));
      MisuseWorld w(GetParam());
      const Sight before(w);
      try {
        argument.call(w, x);
      } catch (const Error&) {
        EXPECT_TRUE(Sight(w) == before);
        continue;
      }
      const Sight sight(w);
      try {
        w.world.step(0.01f);
      } catch (const Error&) {
        expect_same_state(sight, Sight(w));
      }
      EXPECT_TRUE(is_finite(w));
    }
  }
}

/// Each is finite, and steps with their sum would fail for ever.
TEST_P(MisuseArgumentsTest, SumsOfForcesStayFinite) {
  MisuseWorld w(GetParam());
  constexpr float most = std::numeric_limits<float>::max();
  const auto push = [&] {
    w.world.apply_force(w.box, {most, 0, 0}, w.world.body_state(w.box).centre_of_mass);
  };
  const auto twist = [&] { w.world.apply_torque(w.other_box, {0, most, 0}); };
  push(), twist();
  expect_error(ErrorCode::invalid_argument, "apply_force's force", push);
  expect_error(ErrorCode::invalid_argument, "apply_torque's torque", twist);
  expect_error(ErrorCode::invalid_argument, "apply_force's point", [&] {
    w.world.apply_force(w.other_box, {1, 0, 0}, {0, 0, most});
  });
  w.world.apply_force(w.box, {-most, 0, 0}, w.world.body_state(w.box).centre_of_mass);
  w.world.apply_torque(w.other_box, {0, -most, 0});
  w.world.step(0.01f);
  EXPECT_TRUE(is_finite(w));
}

TEST_P(MisuseArgumentsTest, ListsMustFitOneAnother) {
  MisuseWorld w(GetParam());
  const Sight before(w);
  const auto refuse = [&](ErrorCode code, const char* named, const auto& call) {
    expect_error(code, named, call);
    EXPECT_TRUE(Sight(w) == before);
  };
  const std::vector<Vec3> one{{0, 2, 0}}, both = two(1);
  const std::vector<uint32_t> same{1, 1}, beyond{1, 99};
  const std::vector<ParticleId> same_particle{3, 3}, unknown{3, 99};
  constexpr ErrorCode invalid = ErrorCode::invalid_argument;
  refuse(invalid, "2 velocities", [&] { w.world.add_particles(w.water, one, both); });
  refuse(invalid, "1 impulses", [&] { w.world.apply_impulses(two_particles, one); });
  refuse(invalid, "3 twice", [&] { w.world.apply_impulses(same_particle, both); });
  refuse(ErrorCode::not_found, "99", [&] { w.world.apply_impulses(unknown, both); });
  refuse(ErrorCode::not_found, "99", [&] { w.world.remove_particles(unknown); });
  refuse(invalid, "1 impulses", [&] { w.world.apply_impulses(w.cloth, two_vertices, one); });
  refuse(invalid, "1 twice", [&] { w.world.apply_impulses(w.cloth, same, both); });
  refuse(invalid, "99", [&] { w.world.apply_impulses(w.cloth, beyond, both); });
  refuse(invalid, "99", [&] { w.world.apply_impulses(w.string, beyond, both); });
  refuse(invalid, "2 positions for 27 particles", [&] { w.world.set_positions(both); });
  refuse(invalid, "2 velocities for 27 particles", [&] { w.world.set_velocities(both); });
  refuse(invalid, "2 positions for 0 particles", [&] { w.world.set_positions(w.sand, both); });
  refuse(invalid, "1 velocities for 27 particles", [&] { w.world.set_velocities(w.water, one); });
  refuse(invalid, "1 positions for 2 ids", [&] { w.world.set_positions(two_particles, one); });
  refuse(invalid, "3 twice", [&] { w.world.set_positions(same_particle, both); });
  refuse(invalid, "3 twice", [&] { w.world.set_velocities(same_particle, both); });
  refuse(ErrorCode::not_found, "99", [&] { w.world.set_positions(unknown, both); });
  refuse(ErrorCode::not_found, "99", [&] { w.world.set_velocities(unknown, both); });
  refuse(invalid, "2 positions for 16 vertices", [&] { w.world.set_cloth_positions(w.cloth, both); });
  refuse(invalid, "2 velocities for 16 vertices", [&] { w.world.set_cloth_velocities(w.cloth, both); });
  refuse(invalid, "2 positions for 5 vertices", [&] { w.world.set_rope_positions(w.string, both); });
  refuse(invalid, "2 velocities for 5 vertices", [&] { w.world.set_rope_velocities(w.string, both); });
  refuse(invalid, "belt_velocity", [&] { w.world.set_surface(w.box, {.belt_velocity = {1, 0, 0}}); });
  refuse(invalid, "dynamic", [&] { w.world.set_body_velocity(w.door, {}, {}); });
  refuse(invalid, "dynamic", [&] { w.world.apply_force(w.door, {}, {}); });
  refuse(invalid, "dynamic", [&] { w.world.apply_torque(w.door, {}); });
  refuse(invalid, "dynamic", [&] { w.world.apply_impulse(w.door, {}, {}); });
  refuse(invalid, "kinematic", [&] { w.world.move_body(w.box, {}, 1); });
  refuse(invalid, "ellipsoids", [&] { w.world.write_particles(ParticleArrays{}); });
}

MENISCUS_ON_EACH_DEVICE(MisuseArgumentsTest);

}  // namespace
}  // namespace meniscus::tests
