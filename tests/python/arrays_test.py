# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""NumPy read-outs: without a copy, read-only, and frozen while they are held."""

import os
import random
import time
import unittest

import meniscus
import numpy as np

SEQUENCES = int(os.environ.get("MENISCUS_SEQUENCES", "1000"))


def pool(**members):
    world = meniscus.World(particle_spacing=0.1, substeps=1, iterations=2, device="cpu", threads=1, **members)
    world.add_shape(geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.5)))
    water = world.add_fluid()
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.5), upper=(0, 0, 0)))
    return world, water


class Arrays(unittest.TestCase):
    def test_types_and_shapes(self):
        world, water = pool()
        n = world.particle_count
        self.assertGreater(n, 50)
        for name, shape, dtype in (("positions", (n, 3), np.float32), ("velocities", (n, 3), np.float32),
                                   ("ids", (n,), np.uint64), ("fluid_indices", (n,), np.uint32),
                                   ("density_errors", (n,), np.float32), ("pressures", (n,), np.float32)):
            array = getattr(world, name)
            self.assertEqual((array.shape, array.dtype), (shape, dtype), name)
        self.assertEqual(world.ellipsoids.rotations.shape, (n, 4))
        np.testing.assert_allclose(np.linalg.norm(world.ellipsoids.rotations, axis=1), 1, atol=1e-5)

    def test_read_only(self):
        world, _ = pool()
        with self.assertRaises(ValueError):
            world.positions[0, 0] = 1
        with self.assertRaises(ValueError):
            world.positions.flags.writeable = True

    def test_no_copy(self):
        world, _ = pool()
        self.assertIs(world.positions, world.positions)
        self.assertFalse(world.positions.flags.owndata)
        address = world.positions.__array_interface__["data"][0]
        world.step()
        # Nobody held it: the world wrote to the same memory.
        self.assertEqual(world.positions.__array_interface__["data"][0], address)
        held = world.positions
        world.step()
        self.assertNotEqual(world.positions.__array_interface__["data"][0], address)
        self.assertEqual(held.__array_interface__["data"][0], address)

    def test_outlives_the_world(self):
        world, _ = pool()
        array, before = world.positions, world.positions.copy()
        del world
        np.testing.assert_array_equal(array, before)

    def test_empty(self):
        world = meniscus.World(device="cpu")
        self.assertEqual(world.positions.shape, (0, 3))
        self.assertEqual(world.ellipsoids.centres.shape, (0, 3))
        self.assertEqual(world.diffuse.positions.shape, (0, 3))

    def test_access_time(self):
        world, _ = pool()
        world.positions

        def best():
            start = time.perf_counter()
            for _ in range(10_000):
                world.positions
            return (time.perf_counter() - start) / 10_000

        self.assertLess(min(best() for _ in range(10)), 2e-6)

    def test_diffuse(self):
        world, _ = pool(diffuse=meniscus.DiffuseDef(crest_rate=1e5, energy=(meniscus.Range(low=0, high=0.1)),
                                                    crest=meniscus.Range(low=0, high=0.01), capacity=1000))
        for _ in range(20):
            world.step(0.02)
        spray = world.diffuse
        self.assertGreater(len(spray.life), 10)
        self.assertTrue((spray.life > 0).all() and (spray.kinds <= 2).all())
        self.assertTrue((np.abs(spray.positions) < 1).all())

    def test_random_sequences(self):
        """Sequences of reads, steps, changes and drops leave held arrays as they were."""
        names = ("positions", "velocities", "ids", "fluid_indices", "density_errors", "pressures")
        held_in_all = 0
        for seed in range(SEQUENCES):
            choice = random.Random(seed)
            if seed % 50 == 0:
                world, water = pool()
                cloth = world.add_cloth(geometry=meniscus.SheetGeometry(columns=3, rows=3),
                                        pose=(0, 0.3, 0))
                snapshot = world.snapshot()
            held = []
            for _ in range(8):
                what = choice.randrange(8)
                if what <= 1:
                    array = getattr(world, choice.choice(names))
                    held.append((array, array.copy()))
                elif what == 2:
                    array = choice.choice((cloth.positions, cloth.normals, world.ellipsoids.radii))
                    held.append((array, array.copy()))
                elif what == 3:
                    world.step(0.001)
                elif what == 4 and world.particle_count < 300:
                    world.add_particles(water, [(choice.uniform(0.1, 0.4), 0.3, choice.uniform(-0.4, 0.4))])
                elif what == 4:
                    world.remove_particles(world.ids[::2])
                elif what == 5:
                    arrays = world.device_arrays()
                    array = choice.choice((np.from_dlpack(arrays.velocities), np.asarray(arrays.positions)))
                    held.append((array, array.copy()))
                elif what == 6:
                    self.change(world, snapshot, choice)
                elif held:
                    held.pop(choice.randrange(len(held)))
            for array, before in held:
                np.testing.assert_array_equal(array, before, err_msg=f"sequence {seed}")
            held_in_all += len(held)
        self.assertGreater(held_in_all, SEQUENCES)

    def change(self, world, snapshot, choice):
        """One of the calls that set the state."""
        if choice.random() < 0.3:
            world.restore(snapshot)
        elif choice.random() < 0.5:
            world.velocities = world.velocities * 0.5
        else:
            world.positions = world.positions + (0, 0.001, 0)


class Input(unittest.TestCase):
    def test_any_array_of_the_host(self):
        rows = np.array([(0.1, 0.2, 0.3), (0.3, 0.2, 0.1)])
        for given in (rows, rows.astype(np.float32), rows.tolist(), np.asfortranarray(rows), rows[::-1][::-1],
                      (rows * 10).astype(int) / 10, memoryview(rows)):
            world = meniscus.World(device="cpu")
            first = world.add_particles(world.add_fluid(), given, velocities=given)
            self.assertEqual(first, 0)
            np.testing.assert_array_equal(world.positions, rows.astype(np.float32))
            np.testing.assert_array_equal(world.velocities, rows.astype(np.float32))

    def test_dlpack_alone(self):
        class Foreign:
            def __init__(self, array):
                self.array = array

            def __dlpack__(self, **options):
                return self.array.__dlpack__(**options)

            def __dlpack_device__(self):
                return self.array.__dlpack_device__()

        world = meniscus.World(device="cpu")
        world.add_particles(world.add_fluid(), Foreign(np.ones((2, 3), np.float32) * [[1], [2]]))
        np.testing.assert_array_equal(world.positions, [[1, 1, 1], [2, 2, 2]])

    def test_refused(self):
        world = meniscus.World(device="cpu")
        water = world.add_fluid()
        for given in (np.zeros((2, 2)), np.zeros(3), "abc", [["a", "b", "c"]], 3, None):
            with self.assertRaises((TypeError, ValueError), msg=repr(given)):
                world.add_particles(water, given)
        with self.assertRaises(ValueError):
            world.remove_particles([-1])
        with self.assertRaises(meniscus.NotFoundError):
            world.remove_particles([5])
        self.assertEqual(world.particle_count, 0)

    def test_assigned(self):
        world = meniscus.World(device="cpu")
        water = world.add_fluid()
        first = world.add_particles(water, [(0, 0, 0), (1, 0, 0)])
        held = world.positions
        world.positions = held + (0, 1, 0)
        world.velocities = [(1, 2, 3), (4, 5, 6)]
        world.set_positions([first + 1], np.array([(2, 2, 2)], np.float32))
        world.set_velocities([first], [(0, 0, 0)])
        np.testing.assert_array_equal(world.positions, [[0, 1, 0], [2, 2, 2]])
        np.testing.assert_array_equal(world.velocities, [[0, 0, 0], [4, 5, 6]])
        np.testing.assert_array_equal(held, [[0, 0, 0], [1, 0, 0]])
        with self.assertRaises(ValueError):
            world.positions = [(0, 0, 0)]
        cloth = world.add_cloth(geometry=meniscus.SheetGeometry(columns=3, rows=3))
        cloth.positions = cloth.positions + (0, 2, 0)
        cloth.velocities = np.ones_like(cloth.positions)
        self.assertEqual(cloth.positions[5][1], 2)
        np.testing.assert_array_equal(cloth.velocities[5], [1, 1, 1])

    def test_impulses(self):
        world = meniscus.World(device="cpu")
        water = world.add_fluid()
        first = world.add_particles(water, [(0, 0, 0), (1, 0, 0)])
        world.apply_impulses([first + 1], [(water.particle_mass, 0, 0)])
        np.testing.assert_allclose(world.velocities, [[0, 0, 0], [1, 0, 0]], rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
