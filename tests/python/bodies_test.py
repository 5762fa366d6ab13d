# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Bodies and shapes: motion, properties, forces, surfaces, poses."""

import math
import unittest

import meniscus
import numpy as np


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


def box(size=0.1):
    return meniscus.BoxGeometry(half_extents=(size, size, size))


class Bodies(unittest.TestCase):
    def test_falls_as_a_stone(self):
        world = empty(substeps=8)
        body = world.add_body(name="crate", geometry=box(), pose=(0, 10, 0), density=1000, can_sleep=False)
        self.assertAlmostEqual(body.mass, 8, places=4)
        self.assertAlmostEqual(body.volume, 0.008, places=6)
        for _ in range(60):
            world.step(1 / 60)
        self.assertAlmostEqual(world.time, 1, places=5)
        self.assertAlmostEqual(body.velocity[1], -9.81, delta=0.05)
        self.assertAlmostEqual(body.position[1], 10 - 9.81 / 2, delta=0.1)

    def test_set(self):
        world = empty(gravity=(0, 0, 0))
        body = world.add_body(geometry=box(), friction=0.5, mass=2)
        self.assertEqual(body.mass, 2)
        body.position = np.array([1, 2, 3])
        body.rotation = meniscus.axis_angle((0, 0, 2), 90)
        body.velocity = (1, 0, 0)
        body.angular_velocity = (0, 1, 0)
        self.assertEqual((body.position, body.velocity, body.angular_velocity), ((1, 2, 3), (1, 0, 0), (0, 1, 0)))
        np.testing.assert_allclose(body.rotation, (0, 0, math.sqrt(0.5), math.sqrt(0.5)), atol=1e-6)
        self.assertEqual(body.pose.position, (1, 2, 3))
        world.step(0.1)
        self.assertAlmostEqual(body.position[0], 1.1, places=4)

    def test_forces(self):
        world = empty(gravity=(0, 0, 0))
        body = world.add_body(geometry=box(), mass=2, can_sleep=False)
        body.apply_impulse((2, 0, 0))
        self.assertAlmostEqual(body.velocity[0], 1, places=5)
        body.apply_force((0, 20, 0))
        world.step(0.1)
        self.assertAlmostEqual(body.velocity[1], 1, places=4)
        body.apply_torque((0, 0, 1))
        world.step(0.1)
        self.assertAlmostEqual(body.angular_velocity[2], 0.1 / body.inertia[2], places=3)

    def test_kinematic(self):
        world = empty()
        cup = world.add_body(geometry=box(), motion="kinematic")
        cup.move_to((0, 1, 0), 0.1)
        world.step(0.1)
        self.assertAlmostEqual(cup.position[1], 1, places=5)
        with self.assertRaises(meniscus.InvalidArgumentError):
            cup.apply_force((1, 0, 0))
        turned = world.add_body(geometry=box(), motion="kinematic", loop=True, keyframes=[
            meniscus.Keyframe(time=0, position=(1, 0, 0)), {"time": 1, "position": (2, 0, 0)}])
        world.step(0.4)
        self.assertAlmostEqual(turned.position[0], 1.5, places=3)


class Shapes(unittest.TestCase):
    def test_surface_and_filter(self):
        world = empty()
        slope = world.add_shape(name="slope", geometry=box(2), pose=meniscus.Pose(
            position=(0, -2, 0), rotation=meniscus.axis_angle((0, 0, 1), -10)), solid_friction=0, friction=0.4)
        body = world.add_body(geometry=box(), pose=meniscus.Pose(
            position=(0.02, 0.14, 0), rotation=meniscus.axis_angle((0, 0, 1), -10)), can_sleep=False)
        self.assertAlmostEqual(slope.friction, 0.4)
        for _ in range(20):
            world.step(1 / 60)
        self.assertGreater(body.velocity[0], 0.3)  # slides, as there is no friction
        slope.solid_friction = 1
        body.solid_friction = 1
        for _ in range(60):
            world.step(1 / 60)
        self.assertLess(abs(body.velocity[0]), 0.05)
        self.assertAlmostEqual(slope.friction, 0.4)
        body.groups = 2
        slope.mask = 1
        self.assertEqual((body.groups, body.mask, slope.mask), (2, 0xffffffff, 1))
        for _ in range(10):
            world.step(1 / 60)
        self.assertLess(body.velocity[1], -1)  # falls through
        with self.assertRaisesRegex(ValueError, "restitution"):
            slope.restitution = 2
        self.assertEqual(slope.restitution, 0)

    def test_shape_pose(self):
        world = empty()
        floor = world.add_shape(name="floor", geometry=box(1), pose=(0, -1, 0))
        body = world.add_body(geometry=box(), pose=(0, 0.11, 0), can_sleep=False)
        world.step(1 / 60)
        floor.pose = (0, -3, 0)
        self.assertEqual((floor.position, floor.rotation), ((0, -3, 0), (0, 0, 0, 1)))
        self.assertAlmostEqual(world.cast_ray((0.5, 5, 0), (0.5, -9, 0)).distance, 7, places=3)
        for _ in range(20):
            world.step(1 / 60)
        self.assertLess(body.velocity[1], -2)
        floor.position = (1, -3, 0)
        floor.rotation = meniscus.axis_angle((0, 1, 0), 30)
        self.assertEqual(floor.pose.position, (1, -3, 0))
        floor.destroy()
        with self.assertRaises(meniscus.NotFoundError):
            floor.pose


if __name__ == "__main__":
    unittest.main()
