# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Messages, memory, the time of a step, and motions from files."""

import gc
import pathlib
import sys
import tempfile
import unittest
import weakref

import meniscus


def pool(**members):
    world = meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)
    water = world.add_fluid()
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(0.5, 0.5, 0.5)))
    return world


class Log(unittest.TestCase):
    def setUp(self):
        self.messages = []

    def log(self, level, text):
        self.messages.append((level, text))

    def overlapping(self, **members):
        world = meniscus.World(device="cpu", particle_spacing=0.1, **members)
        for x in (0, 0.1):
            world.add_body(geometry=meniscus.BoxGeometry(half_extents=(0.1, 0.1, 0.1)), pose=(x, 0, 0))
        return world

    def test_notes_and_warnings(self):
        world = self.overlapping(log=self.log)
        self.assertEqual([level for level, text in self.messages], ["note"])
        self.assertIn(world.device_info.name, self.messages[0][1])
        (warning,) = world.warnings()
        world.run(3, 1e-4)
        self.assertEqual(self.messages[1:], [("warning", warning)])

    def test_worlds_from_elsewhere(self):
        world = self.overlapping(log=self.log)
        clone = world.clone()
        self.assertEqual(len(self.messages), 2)
        others = []
        world.clone(log=lambda level, text: others.append(text))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "state.meniscus"
            world.save(path)
            meniscus.World.load(path, log=lambda level, text: others.append(text))
            meniscus.World.load(path)
        meniscus.load_scene("hanging_cloth", device="cpu", log=lambda level, text: others.append(text))
        self.assertEqual((len(self.messages), len(others)), (2, 3))
        del world
        gc.collect()
        clone.step(1e-4)
        self.assertEqual(len(self.messages), 3)

    def test_an_exception_ends_no_call(self):
        raised = []
        old, sys.unraisablehook = sys.unraisablehook, lambda what: raised.append(str(what.exc_value))

        def fail(level, text):
            raise RuntimeError("full")

        try:
            world = self.overlapping(log=fail)
            world.step(1e-4)
        finally:
            sys.unraisablehook = old
        self.assertEqual(raised, ["full", "full"])
        self.assertAlmostEqual(world.time, 1e-4)
        with self.assertRaisesRegex(TypeError, "log must be a function"):
            meniscus.World(log=3)

    def test_garbage_is_collected(self):
        class Owner:
            def __init__(self):
                self.world = meniscus.World(device="cpu", log=self.log)
                self.clone = self.world.clone()

            def log(self, level, text):
                pass

        owner = Owner()
        gone = weakref.ref(owner)
        del owner
        gc.collect()
        self.assertIsNone(gone())


class Steps(unittest.TestCase):
    def test_iterations(self):
        world = pool(iterations=6)
        self.assertEqual([world.step(0.01).iterations, world.step(0.01, 3).iterations,
                          world.step(dt=0.01, iterations=9).iterations, world.step(0.01).iterations], [6, 3, 9, 6])
        world.step_begin(0.01, iterations=2)
        self.assertEqual(world.step_end().iterations, 2)
        before = world.state_hash()
        for wrong in (0, 1001):
            with self.assertRaisesRegex(ValueError, "iterations"):
                world.step(0.01, wrong)
        self.assertEqual(world.state_hash(), before)

    def test_budget(self):
        world = pool(iterations=6, step_budget_ms=1e-6)
        self.assertEqual([world.step(0.01).iterations for _ in range(3)], [6, 1, 1])
        self.assertEqual(world.step(0.01, 4).iterations, 4)
        world.step_budget_ms = 0
        self.assertEqual(world.step(0.01).iterations, 6)

    def test_memory(self):
        world = pool()
        world.run(3, 0.01)
        before = world.memory_stats()
        self.assertGreater(before.device.bytes, 0)
        self.assertGreaterEqual(before.device.peak_bytes, before.device.bytes)
        snapshot = world.snapshot()
        after = world.memory_stats()
        self.assertGreaterEqual(after.device.bytes, before.device.bytes + snapshot.device_bytes // 2)
        self.assertGreater(after.device.allocations, before.device.allocations)
        self.assertIn("allocations=", repr(after.shared))


class Motions(unittest.TestCase):
    def test_keyframes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "arm.csv"
            path.write_text("time,x,y,z,qx,qy,qz,qw\n0,1,0,0,0,0,0,1\n2,3,0,0,0,0,0,1\n")
            frames = meniscus.read_keyframes(file=path, start=1, scale=0.5, pose=(0, 4, 0))
        self.assertEqual([(frame.time, frame.position) for frame in frames], [(1, (0.5, 4, 0)), (3, (1.5, 4, 0))])
        world = meniscus.World(device="cpu")
        arm = world.add_body(geometry=meniscus.BoxGeometry(half_extents=(0.1, 0.1, 0.1)), motion="kinematic",
                             keyframes=frames)
        world.step(2)
        self.assertAlmostEqual(arm.position[0], 1, places=4)

    def test_other_sources_and_errors(self):
        asked = []

        def read(name):
            asked.append(name)
            return b"0 0 0 0 0 0 0 1\n1 0 2 0 0 0 0 1\n" if name == "arm.tum" else None

        self.assertEqual(meniscus.read_keyframes(file="arm.tum", read_file=read)[1].position, (0, 2, 0))
        self.assertEqual(asked, ["arm.tum"])
        with self.assertRaises(OSError):
            meniscus.read_keyframes(file="leg.tum", read_file=read)
        with self.assertRaises(meniscus.SceneError):
            meniscus.read_keyframes(file="arm.tum", read_file=lambda name: b"0 0 zero\n")
        with self.assertRaisesRegex(ValueError, "mp3"):
            meniscus.read_keyframes(file="arm.mp3", read_file=lambda name: b"")
        with self.assertRaisesRegex(TypeError, "did you mean \"scale\""):
            meniscus.read_keyframes(file="arm.tum", scal=2)
        with self.assertRaisesRegex(TypeError, "needs the argument file"):
            meniscus.read_keyframes()


if __name__ == "__main__":
    unittest.main()
