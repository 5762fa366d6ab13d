# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Arrays in the memory of the device: DLPack, the interfaces of arrays, steps in two halves. On the CPU."""

import gc
import importlib.util
import unittest

import meniscus
import numpy as np


def pool():
    world = meniscus.World(particle_spacing=0.1, substeps=1, iterations=2, device="cpu", threads=1)
    world.add_shape(geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.5)))
    water = world.add_fluid()
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.5), upper=(0, 0, 0)))
    return world


class DeviceArrays(unittest.TestCase):
    def test_hold_what_read_outs_hold(self):
        world = pool()
        world.step(0.01)
        arrays = world.device_arrays()
        for name in ("ids", "positions", "velocities"):
            array = getattr(arrays, name)
            np.testing.assert_array_equal(np.asarray(array), getattr(world, name))
            self.assertEqual((array.shape, array.dtype), (getattr(world, name).shape, getattr(world, name).dtype.name))
        np.testing.assert_array_equal(np.asarray(arrays.phases), world.fluid_indices)
        positions = arrays.positions
        self.assertEqual((positions.device, positions.ordinal, positions.stream, positions.read_only, len(positions)),
                         ("cpu", 0, 0, False, world.particle_count))
        self.assertEqual(repr(positions), f"<DeviceArray {world.particle_count} x 3, <f4, cpu>")

    def test_same_pointer(self):
        positions = pool().device_arrays().positions
        self.assertEqual(np.asarray(positions).__array_interface__["data"][0], positions.pointer)
        self.assertEqual(np.from_dlpack(positions).__array_interface__["data"][0], positions.pointer)

    def test_stay_while_held(self):
        world = pool()
        kept = np.from_dlpack(world.device_arrays().positions)
        before = kept.copy()
        world.step(0.01)
        self.assertNotEqual(world.device_arrays().positions.pointer, kept.__array_interface__["data"][0])
        del world
        gc.collect()
        np.testing.assert_array_equal(kept, before)

    def test_memory_serves_again(self):
        world = pool()
        address = world.device_arrays().positions.pointer
        world.step(0.01)
        self.assertEqual(world.device_arrays().positions.pointer, address)
        world.device_arrays().positions.__dlpack__()  # a capsule that nobody takes
        self.assertEqual(world.device_arrays().positions.pointer, address)

    def test_dlpack_protocol(self):
        positions = pool().device_arrays().positions
        self.assertEqual(positions.__dlpack_device__(), (1, 0))
        for good in ({}, {"stream": None}, {"stream": -1}, {"max_version": (0, 8)}, {"dl_device": (1, 0)},
                     {"copy": False}):
            self.assertIn('"dltensor"', repr(positions.__dlpack__(**good)))
        for later in ((1, 0), (1, 1), (2, 0)):
            self.assertIn('"dltensor_versioned"', repr(positions.__dlpack__(max_version=later)))
        self.assertTrue(np.from_dlpack(positions).flags.writeable)
        for bad in ({"copy": True}, {"dl_device": (2, 0)}):
            with self.assertRaises(BufferError):
                positions.__dlpack__(**bad)
        with self.assertRaises(ValueError):
            positions.__dlpack__(stream=1)
        with self.assertRaises(AttributeError):
            positions.__cuda_array_interface__

    def test_empty(self):
        arrays = meniscus.World(device="cpu").device_arrays()
        self.assertEqual(np.asarray(arrays.positions).shape, (0, 3))
        self.assertEqual(np.from_dlpack(arrays.ids).shape, (0,))

    @unittest.skipUnless(importlib.util.find_spec("torch"), "torch is not here")
    def test_torch(self):
        import torch
        world = pool()
        tensor = torch.from_dlpack(world.device_arrays().positions)
        np.testing.assert_array_equal(tensor.numpy(), world.positions)
        world.positions = tensor + torch.tensor([0, 0.01, 0])
        np.testing.assert_allclose(world.positions, tensor.numpy() + [0, 0.01, 0], atol=1e-7)

    @unittest.skipUnless(importlib.util.find_spec("jax"), "jax is not here")
    def test_jax(self):
        import jax
        world = pool()
        array = jax.numpy.from_dlpack(world.device_arrays().positions)
        np.testing.assert_array_equal(np.asarray(array), world.positions)
        world.velocities = array * 0 + 1
        np.testing.assert_array_equal(world.velocities, np.ones_like(world.positions))


class HalfSteps(unittest.TestCase):
    def test_equal_a_step(self):
        whole, halves = pool(), pool()
        for _ in range(3):
            report = whole.step(0.01)
            halves.step_begin(0.01)
            with self.assertRaises(ValueError):
                halves.positions
            with self.assertRaises(ValueError):
                halves.step(0.01)
            self.assertEqual(halves.step_end().substeps, report.substeps)
        self.assertEqual(whole.state_hash(), halves.state_hash())
        with self.assertRaises(ValueError):
            halves.step_end()


if __name__ == "__main__":
    unittest.main()
