# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Long calls: other threads run, Ctrl-C and cancel end them, and two threads take turns."""

import _thread
import threading
import time
import unittest

import meniscus


def slow_world():
    """One whose step takes many seconds."""
    world = meniscus.World(particle_spacing=0.05, device="cpu", threads=1, substeps=1000, iterations=100)
    world.add_shape(geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.5)))
    world.add_volume(fluid=world.add_fluid(), region=meniscus.BoxRegion())
    return world


class Interrupts(unittest.TestCase):
    def test_ctrl_c(self):
        world = slow_world()
        before = world.state_hash()
        timer = threading.Timer(0.3, _thread.interrupt_main)
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            world.step(1 / 60)
        self.assertLess(time.monotonic() - start, 20)
        self.assertEqual((world.state_hash(), world.time), (before, 0))
        world.substeps, world.iterations = 1, 1
        world.step(1e-4)
        self.assertGreater(world.time, 0)

    def test_cancel_from_another_thread(self):
        world = slow_world()
        threading.Timer(0.3, world.cancel).start()
        with self.assertRaises(meniscus.CancelledError):
            world.step(1 / 60)

    def test_progress(self):
        world = slow_world()
        seen = []

        def report(what, fraction):
            seen.append((what, fraction))
            with self.assertRaises(ValueError):
                world.time
            if len(seen) == 3:
                raise LookupError("enough")

        world.on_progress = report
        with self.assertRaisesRegex(LookupError, "enough"):
            world.step(1 / 60)
        self.assertEqual(len(seen), 3)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in seen))
        world.on_progress = None

    def test_other_threads_run(self):
        world = slow_world()
        ticks = []
        ended = threading.Event()

        def count():
            while not ended.wait(0.02):
                ticks.append(time.monotonic())
                if len(ticks) == 20:
                    world.cancel()

        thread = threading.Thread(target=count)
        thread.start()
        try:
            with self.assertRaises(meniscus.CancelledError):
                world.step(1 / 60)
        finally:
            ended.set()
            thread.join()
        self.assertGreaterEqual(len(ticks), 20)

    def test_threads_take_turns(self):
        world = meniscus.World(particle_spacing=0.1, device="cpu", threads=1)
        world.add_volume(fluid=world.add_fluid(), region=meniscus.BoxRegion())
        faults = []

        def use(read):
            try:
                for _ in range(20):
                    if read:
                        assert world.positions.shape == (world.particle_count, 3)
                    else:
                        world.step(0.001)
            except BaseException as error:
                faults.append(error)

        threads = [threading.Thread(target=use, args=(k % 2,)) for k in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(faults, [])
        self.assertAlmostEqual(world.time, 0.06, places=5)


if __name__ == "__main__":
    unittest.main()
