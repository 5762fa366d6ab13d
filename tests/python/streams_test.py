# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Device arrays on a GPU: PyTorch, CuPy, JAX and Numba see the same memory, and see it complete on any stream. Skipped
without a GPU or without PyTorch. With --all as well those of the others that are here.

One stress is 100 steps. A world that nobody looks at gives the right values. A second one steps as fast as it can, while
another stream reads its arrays and is kept busy, so that it lags behind."""

import importlib.util
import sys
import unittest

import meniscus
import numpy as np

STEPS = 100


def has(package):
    return importlib.util.find_spec(package) is not None


if not has("torch") or not any(device.kind == "cuda" and device.usable for device in meniscus.list_devices()):
    print("no PyTorch or no GPU")
    sys.exit(77)

import torch  # noqa: E402


def dam(device="cuda", **members):
    world = meniscus.World(particle_spacing=0.02, substeps=2, iterations=4, device=device, **members)
    world.add_shape(geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.2)))
    water = world.add_fluid(xsph=10)
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.2), upper=(0, 0.3, 0.2)))
    return world


def expected():
    """Positions and velocities after each step."""
    world, results = dam(), []
    for _ in range(STEPS):
        world.step(0.005)
        results.append((world.positions.copy(), world.velocities.copy()))
    return results


def lag(stream):
    """Work for some milliseconds on the stream."""
    with torch.cuda.stream(stream):
        torch.cuda._sleep(5_000_000)


class Streams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.right = expected()

    def compare(self, copies):
        torch.cuda.synchronize()
        for step, (copy, right) in enumerate(zip(copies, self.right, strict=True)):
            for got, wanted in zip(copy, right, strict=True):
                np.testing.assert_array_equal(got.cpu().numpy(), wanted, err_msg=f"step {step}")

    def stress(self, world, take, stream):
        """Copies on the stream, with the arrays held until the work on them is done."""
        copies, held = [], []
        for step in range(STEPS):
            world.step(0.005)
            arrays = world.device_arrays()
            if step % 10 == 0:
                lag(stream)
            with torch.cuda.stream(stream):
                tensors = [take(array) for array in (arrays.positions, arrays.velocities)]
                copies.append([tensor.clone() for tensor in tensors])
            done = torch.cuda.Event()
            done.record(stream)
            held.append((done, tensors, arrays))
            held = [item for item in held if not item[0].query()]
            del arrays, tensors
        self.compare(copies)

    def test_same_memory(self):
        world = dam()
        world.step(0.005)
        arrays = world.device_arrays()
        self.assertEqual(arrays.positions.__dlpack_device__(), (2, 0))
        tensor = torch.from_dlpack(arrays.positions)
        self.assertEqual((tensor.data_ptr(), tensor.device.type), (arrays.positions.pointer, "cuda"))
        self.assertEqual(torch.as_tensor(arrays.positions, device="cuda").data_ptr(), arrays.positions.pointer)
        np.testing.assert_array_equal(tensor.cpu().numpy(), world.positions)
        interface = arrays.ids.__cuda_array_interface__
        self.assertEqual((interface["data"], interface["typestr"], interface["stream"]),
                         ((arrays.ids.pointer, False), "<u8", arrays.ids.stream))
        with self.assertRaises(ValueError):
            arrays.positions.__dlpack__(stream=0)
        with self.assertRaises(AttributeError):
            arrays.positions.__array_interface__
        held = torch.from_dlpack(world.device_arrays().positions)
        before = held.clone()
        world.step(0.005)
        del world, arrays
        torch.cuda.synchronize()
        self.assertTrue(torch.equal(held, before))

    def test_a_given_stream(self):
        stream = torch.cuda.Stream()
        self.stress(dam(), torch.from_dlpack, stream)

    def test_the_legacy_stream(self):
        self.stress(dam(), torch.from_dlpack, torch.cuda.default_stream())

    def test_the_per_thread_stream(self):
        def take(array):
            return torch.utils.dlpack.from_dlpack(array.__dlpack__(stream=2))

        self.stress(dam(), take, torch.cuda.ExternalStream(2))

    def test_cuda_array_interface(self):
        # PyTorch looks at no "stream": the default stream is ordered all the same.
        self.stress(dam(), lambda array: torch.as_tensor(array, device="cuda"), torch.cuda.default_stream())

    def test_the_callers_stream(self):
        stream = torch.cuda.Stream()
        world = dam(cuda_stream=stream)
        self.assertEqual(world.device_arrays().ids.stream, stream.cuda_stream)
        self.stress(world, torch.from_dlpack, stream)

    def test_halves_of_steps(self):
        world, stream, copies = dam(), torch.cuda.Stream(), []
        world.step_begin(0.005)
        for step in range(STEPS):
            world.step_end()
            arrays = world.device_arrays()
            with torch.cuda.stream(stream):
                copies.append([torch.from_dlpack(a).clone() for a in (arrays.positions, arrays.velocities)])
            stream.synchronize()
            if step + 1 < STEPS:
                world.step_begin(0.005)
        self.compare(copies)

    def test_hooks(self):
        world, plain, host = dam(), dam(), dam("cpu")

        def push(view):
            with torch.cuda.stream(torch.cuda.ExternalStream(view.stream)):
                torch.from_dlpack(view.velocities)[: view.particles, 0] += 3 * view.dt

        def push_on_host(view):
            np.from_dlpack(view.velocities)[: view.particles, 0] += 3 * view.dt

        world.add_hook("velocities_known", push)
        host.add_hook("velocities_known", push_on_host)
        for w in (world, plain, host):
            for _ in range(10):
                w.step(0.001)
        unpushed, pushed, right = (w.velocities.mean(axis=0, dtype=float) for w in (plain, world, host))
        self.assertLess(np.abs(pushed - right).max(), 0.1 * (pushed - unpushed)[0])

    def test_arrays_of_hooks(self):
        def look(view):
            for name in ("phases", "slots"):
                array = getattr(view, name)
                self.assertTrue(array.read_only and array.__cuda_array_interface__["data"][1])
                self.assertIn('"dltensor_versioned"', repr(array.__dlpack__(max_version=(1, 0))))
                for version in (None, (0, 8)):
                    with self.assertRaisesRegex(BufferError, "read-only"):
                        array.__dlpack__(max_version=version)
            seen.append(view.velocities.read_only)

        world, seen = dam(), []
        world.add_hook("solved", look)
        world.step(0.001)  # two substeps, which are repeated where lists had too little room
        self.assertEqual(set(seen), {False})
        self.assertGreaterEqual(len(seen), 2)
        kept = []
        world.add_hook("solved", lambda view: kept.append(torch.from_dlpack(view.positions)))
        with self.assertRaisesRegex(ValueError, "keeps an array"):
            world.step(0.001)

    @unittest.skipUnless("--all" in sys.argv and has("cupy"), "CuPy: with --all, where it is here")
    def test_cupy(self):
        import cupy
        stream = cupy.cuda.Stream(non_blocking=True)

        def take(array):
            with stream:
                taken = cupy.from_dlpack(array)
            self.assertEqual(taken.data.ptr, array.pointer)
            return torch.from_dlpack(taken)

        self.stress(dam(), take, torch.cuda.ExternalStream(stream.ptr))

    @unittest.skipUnless("--all" in sys.argv and has("jax"), "JAX: with --all, where it is here")
    def test_jax(self):
        import jax
        world = dam()
        for step in range(STEPS):
            world.step(0.005)
            seen = jax.numpy.from_dlpack(world.device_arrays().positions)
            np.testing.assert_array_equal(np.asarray(seen), self.right[step][0], err_msg=f"step {step}")

    @unittest.skipUnless("--all" in sys.argv and has("numba"), "Numba: with --all, where it is here")
    def test_numba(self):
        import numba.cuda
        world = dam()
        world.step(0.005)
        array = world.device_arrays().positions
        seen = numba.cuda.as_cuda_array(array)
        self.assertEqual(seen.device_ctypes_pointer.value, array.pointer)
        np.testing.assert_array_equal(seen.copy_to_host(), self.right[0][0])


if __name__ == "__main__":
    unittest.main(argv=[argument for argument in sys.argv if argument != "--all"])
