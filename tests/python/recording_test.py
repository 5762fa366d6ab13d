# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Recordings and their replay."""

import pathlib
import tempfile
import unittest

import meniscus


def box(size=0.1):
    return meniscus.BoxGeometry(half_extents=(size, size, size))


def pool():
    world = meniscus.World(device="cpu", threads=1, particle_spacing=0.1, substeps=2, iterations=4)
    world.add_shape(name="tank", geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.5)))
    water = world.add_fluid(name="water")
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.5), upper=(0, 0, 0.5)))
    return world


class Recordings(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "run.menisrec"

    def replayed(self, replay, world):
        steps = []
        while (step := replay.next(world)) is not None:
            self.assertEqual(step.hash, step.recorded_hash)
            self.assertEqual((step.hash, step.time), (world.state_hash(), world.time))
            steps.append(step)
        return steps

    def test_repeats_what_is_created_set_and_destroyed(self):
        world = pool()
        gone = world.add_body(name="gone", geometry=box(), pose=(0.3, 0, 0.3))
        world.step(0.01)
        world.start_recording(self.path)
        world.step(0.01, 7)
        crate = world.add_body(name="crate", geometry=box(), pose=(0.3, 0, 0), density=300)
        crate.velocity = (0, 1, 0)
        world.step(0.01)
        gone.destroy()
        world.shape("tank").friction = 0.4
        world.fluid("water").xsph = 12
        world.step(0.01)
        world.stop_recording()
        replay = meniscus.Replay(self.path)
        self.assertEqual((replay.device, replay.program, replay.is_complete), ("cpu", meniscus.__version__, False))
        again = replay.start(threads=3)
        self.assertEqual([body.name for body in again.bodies], ["gone"])
        self.assertEqual(again.threads, 3)
        step = replay.next(again)
        self.assertEqual((step.report.iterations, step.hash), (7, step.recorded_hash))
        self.assertEqual([body.name for body in again.bodies], ["gone"])
        replay.next(again)
        self.assertEqual([body.name for body in again.bodies], ["gone", "crate"])
        self.assertEqual(len(self.replayed(replay, again)), 1)
        self.assertTrue(replay.is_complete)
        self.assertEqual([body.name for body in again.bodies], ["crate"])
        self.assertEqual((again.fluid("water").xsph, again.time), (12, world.time))
        self.assertAlmostEqual(again.shape("tank").friction, 0.4)
        self.assertAlmostEqual(again.body("crate").velocity[1], crate.velocity[1])
        again.body("crate").friction = 0.1  # changes nothing else
        for other in (world, again):
            other.body("crate").friction = 0.2
            other.step(0.01)
        self.assertEqual(again.state_hash(), world.state_hash())

    def test_goes_back_to_a_snapshot(self):
        world = pool()
        start = world.snapshot()
        world.step(0.01)
        world.start_recording(self.path)
        world.step_begin(0.01, iterations=3)
        world.step_end()
        world.add_body(name="crate", geometry=box(), pose=(0.3, 0, 0))
        world.step(0.01)
        world.restore(start)
        world.step(0.02)
        world.stop_recording()
        replay = meniscus.Replay(str(self.path))
        again = replay.start()
        calls, progress = [], []
        again.on_progress = lambda what, fraction: progress.append(what)
        hook = again.add_hook("solved", lambda view: calls.append(view.dt))
        old = again.shape("tank")
        self.assertEqual([replay.next(again).report.iterations for _ in range(2)], [3, 4])
        self.assertEqual((len(calls), len(again.bodies)), (4, 1))
        self.assertEqual(len(self.replayed(replay, again)), 1)
        self.assertEqual((len(calls), again.bodies), (6, []))  # the new world keeps the hooks
        self.assertAlmostEqual(again.time, 0.02, places=6)
        with self.assertRaises(meniscus.NotFoundError):
            old.pose = (0, 0, 0)
        again.shape("tank").friction = 0.3
        before = len(progress)
        again.relax(2000)
        self.assertGreater(len(progress), before)  # it still reports
        again.remove_hook(hook)
        before = len(calls)
        again.step(0.01)
        self.assertEqual(len(calls), before)

    def test_misuse(self):
        world = pool()
        with self.assertRaisesRegex(ValueError, "nothing is being recorded"):
            world.stop_recording()
        with self.assertRaises(OSError):
            world.start_recording("/nowhere/run.menisrec")
        world.start_recording(self.path)
        with self.assertRaisesRegex(ValueError, "is recorded"):
            world.start_recording(self.path)
        world.step(0.01)
        world.stop_recording()
        replay = meniscus.Replay(self.path)
        with self.assertRaisesRegex(ValueError, "start has made"):
            replay.next(world)
        with self.assertRaisesRegex(TypeError, "did you mean \"threads\""):
            replay.start(thread=1)
        again = replay.start()
        with self.assertRaisesRegex(ValueError, "before"):
            replay.start()
        self.assertEqual(len(self.replayed(replay, again)), 1)
        self.assertIsNone(replay.next(again))
        whole = self.path.read_bytes()
        self.path.write_bytes(whole[:-10])  # without its end
        cut = meniscus.Replay(self.path)
        self.assertEqual(len(self.replayed(cut, cut.start())), 1)
        self.assertFalse(cut.is_complete)
        self.path.write_bytes(whole[:len(whole) // 2] + bytes([whole[len(whole) // 2] ^ 1])
                              + whole[len(whole) // 2 + 1:])
        with self.assertRaises(meniscus.FileError):
            meniscus.Replay(self.path).start()
        with self.assertRaises(meniscus.FileError):
            meniscus.Replay("/nowhere/run.menisrec")


if __name__ == "__main__":
    unittest.main()
