// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Many objects that are removed one by one: together at the next other call, and with the bits of one at a
// time.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

/// A heap of boxes, some of them jointed, on slabs, with water on it.
struct Heap {
  World world;
  std::vector<ShapeId> slabs;
  std::vector<BodyId> boxes;
  ParticleId first;

  explicit Heap(pbd::DeviceKind device) : world(world_def(device, 0.1f)) {
    const FluidId water = world.create_fluid({});
    world.create_shape(tank({-1, 0, -1}, {1, 2, 1}));
    for (int k = 0; k < 4; ++k) {
      const Vec3 at{-0.6f + 0.4f * float(k), 0.1f, 0};
      slabs.push_back(world.create_shape(shape(BoxGeometry{{0.2f, 0.1f, 0.9f}}, at)));
    }
    for (int k = 0; k < 36; ++k) {
      BodyDef box;
      box.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
      box.pose.position = {-0.6f + 0.21f * float(k % 6), 0.3f + 0.2f * float(k / 18),
                           -0.4f + 0.21f * float(k / 6 % 3)};
      boxes.push_back(world.create_body(box));
    }
    for (size_t k = 0; k < 12; k += 2) {
      JointDef joint;
      joint.a = boxes[k];
      joint.b = boxes[k + 1];
      joint.frame = world.body_state(boxes[k]).pose;
      world.create_joint(joint);
    }
    first = world.add_particles(water, lattice(10, 2, 10, 0.1f, {-0.5f, 1, -0.5f}));
    run(world, 20, 1.0f / 60);
  }
};

class RemovalTest : public OnDevice {
 protected:
  /// Calls with(heap, number) for each number. One of the two worlds carries each removal out by itself.
  template <class Call>
  void remove(std::initializer_list<int> numbers, const Call& call) {
    for (const int n : numbers) call(at_once_, static_cast<size_t>(n));
    for (const int n : numbers) {
      call(in_turn_, static_cast<size_t>(n));
      in_turn_.world.particle_count();
    }
  }
  void expect_same() {
    for (int k = 0; k < 20; ++k) {
      at_once_.world.step(1.0f / 60);
      in_turn_.world.step(1.0f / 60);
      ASSERT_EQ(at_once_.world.state_hash(), in_turn_.world.state_hash()) << k;
      ASSERT_EQ(at_once_.world.contact_events().size(), in_turn_.world.contact_events().size()) << k;
    }
  }

  Heap at_once_{GetParam()}, in_turn_{GetParam()};
};

TEST_P(RemovalTest, ParticlesTogetherAreAsOneAtATime) {
  remove({3, 0, 199, 50, 4, 111}, [](Heap& heap, size_t n) {
    const ParticleId id = heap.first + n;
    heap.world.remove_particles(std::span(&id, 1));
    expect_error(ErrorCode::not_found, std::to_string(id),
                 [&] { heap.world.remove_particles(std::span(&id, 1)); });
  });
  EXPECT_EQ(at_once_.world.particle_count(), 194u);
  EXPECT_EQ(at_once_.world.positions().size(), 194u);
  expect_same();
}

TEST_P(RemovalTest, SolidsTogetherAreAsOneAtATime) {
  remove({2, 17, 5, 16, 0, 30, 9}, [](Heap& heap, size_t n) {
    heap.world.destroy_body(heap.boxes[n]);
    expect_error(ErrorCode::not_found, "body", [&] { heap.world.destroy_body(heap.boxes[n]); });
    if (n == 16) heap.world.destroy_shape(heap.slabs[1]);
  });
  EXPECT_EQ(at_once_.world.particle_contacts().size(), in_turn_.world.particle_contacts().size());
  EXPECT_EQ(at_once_.world.solid_contacts().size(), in_turn_.world.solid_contacts().size());
  expect_same();
}

template <class Call>
double seconds_of(const Call& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class ManyRemovalsTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.1f)};
};

/// When each removal searched the world, removing them took as long as making them, or longer.
TEST_P(ManyRemovalsTest, ShapesAreRemovedInLessTimeThanTheyAreMade) {
  std::vector<ShapeId> shapes;
  const double made = seconds_of([&] {
    for (int k = 0; k < 4000; ++k)
      shapes.push_back(world_.create_shape(
          shape(BoxGeometry{{0.2f, 0.2f, 0.2f}}, {float(k % 20), float(k / 20 % 20), float(k / 400)})));
  });
  EXPECT_LT(seconds_of([&] {
              for (const ShapeId id : shapes) world_.destroy_shape(id);
              world_.particle_count();  // carries them out
            }),
            0.5 * made);
}

TEST_P(ManyRemovalsTest, ParticlesAreRemovedInLinearTime) {
  constexpr size_t many = 30000;  // at the square of this the CPU took 8 s
  const ParticleId first =
      world_.add_particles(world_.create_fluid({}), lattice(30, 100, 10, 0.1f, {0, 0, 0}));
  EXPECT_LT(seconds_of([&] {
              for (size_t k = 0; k < many; ++k) {
                const ParticleId id = first + k;
                world_.remove_particles(std::span(&id, 1));
              }
              EXPECT_EQ(world_.particle_count(), 0u);
            }),
            2);
}

MENISCUS_ON_EACH_DEVICE(RemovalTest);
MENISCUS_ON_EACH_DEVICE(ManyRemovalsTest);

}  // namespace
}  // namespace meniscus::tests
