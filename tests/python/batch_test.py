# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""WorldBatch: copies of a world that move as it does alone."""

import unittest

import meniscus
import numpy as np

DT = 0.01


def archetype(**given):
    world = meniscus.World(device="cpu", particle_spacing=0.1, iterations=3, **{"sums": "fixed", **given})
    world.add_shape(geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.25)))
    world.add_volume(fluid=world.add_fluid(), region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.25), upper=(0, 0, 0.25)))
    return world


class BatchTest(unittest.TestCase):
    def test_a_world_moves_as_alone(self):
        world = archetype()
        batch = meniscus.WorldBatch(world, worlds=3)
        for _ in range(10):
            report = batch.step(DT)
            world.step(DT)
        self.assertEqual(report.stepped, 3)
        self.assertEqual(set(batch.state_hashes.tolist()), {world.state_hash()})
        self.assertEqual(batch.positions.shape, (3, batch.particle_count, 3))
        np.testing.assert_array_equal(batch.positions[1], world.positions)

    def test_worlds_have_their_own_gravity_and_resets(self):
        batch = meniscus.WorldBatch(archetype(), worlds=2)
        start = batch.state_hashes.copy()
        batch.set_gravities(np.array([[0, -9.81, 0], [3, -9.81, 0]], dtype=np.float32))
        batch.step(DT)
        self.assertNotEqual(*batch.state_hashes)
        batch.reset(np.array([False, True]))
        self.assertEqual(batch.state_hashes[1], start[1])
        self.assertEqual([s.time for s in batch.status], [np.float32(DT), 0])
        batch.set_active(np.array([False, True]))
        self.assertEqual(batch.step(DT).stepped, 1)
        with self.assertRaises(TypeError):  # numbers of worlds are no mask
            batch.reset(np.array([0, 1]))

    def test_an_extracted_world_goes_on(self):
        batch = meniscus.WorldBatch(archetype(), worlds=2)
        batch.step(DT)
        world = batch.extract(1)
        batch.step(DT)
        world.step(DT)
        self.assertEqual(world.state_hash(), batch.state_hashes[1])

    def test_cloth_moves_as_alone(self):
        world = archetype()
        sheet = world.add_cloth(geometry=meniscus.SheetGeometry(width=0.4, depth=0.4, columns=7, rows=7), pose=(0.2, 0.3, 0))
        batch = meniscus.WorldBatch(world, worlds=3)
        for _ in range(10):
            batch.step(DT)
            world.step(DT)
        self.assertEqual(set(batch.state_hashes.tolist()), {world.state_hash()})
        self.assertEqual(batch.vertex_count, 49)
        np.testing.assert_array_equal(batch.cloth_positions[2], sheet.positions)
        self.assertEqual(batch.cloth_velocities.shape, (3, 49, 3))
        self.assertEqual(np.from_dlpack(batch.device_arrays().cloth_positions).shape, (3, 49, 3))

    def test_bodies_move_in_one_world(self):
        world = archetype()
        ball = world.add_body(geometry=meniscus.SphereGeometry(radius=0.1), pose=(0.3, 0.3, 0), density=300)
        batch = meniscus.WorldBatch(world, worlds=3, rigid_threads=2)
        batch.set_body_velocity(1, ball, (0, 2, 0), (0, 0, 0))
        batch.apply_force(2, ball, (5, 0, 0))
        batch.step(DT)
        self.assertEqual(batch.body_count, 1)
        self.assertEqual(batch.bodies.positions.shape, (3, 1, 3))
        self.assertEqual(batch.bodies.rotations.shape, (3, 1, 4))
        speeds = batch.bodies.velocities[:, 0]
        self.assertGreater(speeds[1, 1], speeds[0, 1] + 1.9)
        self.assertGreater(speeds[2, 0], speeds[0, 0] + 1e-3)
        world.step(DT)
        self.assertEqual(batch.state_hashes[0], world.state_hash())
        batch.set_body_pose(0, ball, (0.2, 0.4, 0))
        np.testing.assert_allclose(batch.bodies.positions[0, 0], (0.2, 0.4, 0), atol=1e-6)
        with self.assertRaisesRegex(meniscus.Error, "kinematic"):
            batch.move_body(0, ball, (0, 0, 0), DT)

    def test_contacts_and_events_are_of_one_world(self):
        world = archetype()
        ball = world.add_body(geometry=meniscus.SphereGeometry(radius=0.1), pose=(0.3, 0.3, 0), density=3000)
        batch = meniscus.WorldBatch(world, worlds=2)
        batch.set_body_velocity(1, ball, (0, 1, 0), (0, 0, 0))
        events = []
        for _ in range(120):
            batch.step(DT)
            world.step(DT)
            got = batch.contact_events(0)
            self.assertEqual([e.began for e in got], [e.began for e in world.contact_events()])
            events += got
        self.assertTrue(events)
        self.assertEqual((events[0].a, events[0].b), (0, -1))
        self.assertIs(events[0].began, True)
        contacts = batch.solid_contacts(0)
        self.assertEqual(len(contacts.a), len(world.solid_contacts()))
        self.assertEqual(contacts.points.shape, (len(contacts.a), 3))
        self.assertEqual(batch.sleep_events(1), [])
        with self.assertRaisesRegex(meniscus.Error, "world"):
            batch.contact_events(2)

    def test_a_snapshot_is_gone_back_to(self):
        batch = meniscus.WorldBatch(archetype(), worlds=2)
        batch.step(DT)
        kept = batch.snapshot()
        self.assertGreater(kept.device_bytes, 0)
        batch.step(DT)
        later = batch.state_hashes.copy()
        batch.restore(kept)
        batch.step(DT)
        np.testing.assert_array_equal(batch.state_hashes, later)

    def test_a_world_comes_back(self):
        batch = meniscus.WorldBatch(archetype(), worlds=2)
        batch.step(DT)
        world = batch.extract(0)
        world.step(DT)
        batch.insert(1, world)
        self.assertEqual(batch.state_hashes[1], world.state_hash())

    def test_arrays_are_on_the_device(self):
        batch = meniscus.WorldBatch(archetype(), worlds=2)
        arrays = batch.device_arrays()
        self.assertEqual(arrays.positions.shape, (2, batch.particle_count, 3))
        np.testing.assert_array_equal(np.asarray(arrays.positions), batch.positions)

    def test_what_a_batch_does_not_take_is_named(self):
        with self.assertRaisesRegex(meniscus.Error, "sums"):
            meniscus.WorldBatch(archetype(sums="auto"), worlds=2)


if __name__ == "__main__":
    unittest.main()
