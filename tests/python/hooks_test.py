# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Functions of Python within a substep, and files that Python reads for a world."""

import traceback
import unittest

import meniscus
import numpy as np

NAMES = ("predicted", "contacts_found", "iterated", "solved", "velocities_known")
PLATE = b"v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n" + b"".join(
    b"f %d %d %d %d\n" % face for face in ((1, 2, 3, 4), (8, 7, 6, 5), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4),
                                           (4, 8, 5, 1)))


def drop(**members):
    world = meniscus.World(particle_spacing=0.1, substeps=2, iterations=3, device="cpu", threads=2, **members)
    water = world.add_fluid()
    world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(0.3, 0.3, 0.3)))
    return world


class Hooks(unittest.TestCase):
    def test_order_and_contents(self):
        world, seen = drop(), []
        world.add_cloth(geometry=meniscus.SheetGeometry(columns=3, rows=3), pose=(0, -1, 0))

        def look(view):
            rows = view.particles + view.vertices
            self.assertEqual((view.particles, view.vertices), (world_count, 9))
            self.assertEqual((view.positions.shape, view.slots.shape), ((rows, 4), (rows,)))
            self.assertEqual((view.on_cuda, view.device, view.stream), (False, 0, 0))
            self.assertAlmostEqual(view.dt, 0.005, places=6)
            self.assertFalse(view.slots.flags.writeable)
            self.assertTrue(view.positions.flags.writeable)
            self.assertEqual(sorted(view.slots[:view.particles]), list(range(world_count)))
            if view.hook == "velocities_known":
                with self.assertRaises(AttributeError):
                    view.previous
            else:
                self.assertEqual(view.corrections.shape, (rows, 4))
            seen.append((view.hook, view.iteration if view.hook == "iterated" else None, view.is_last))

        world_count = world.particle_count
        hooks = [world.add_hook(name, look) for name in NAMES]
        world.step(0.01)
        one = [("predicted", None), ("contacts_found", None), *(("iterated", k) for k in range(3)), ("solved", None),
               ("velocities_known", None)]
        self.assertEqual(seen, [(*item, last) for last in (False, True) for item in one])
        for hook in hooks:
            world.remove_hook(hook)
        world.step(0.01)
        self.assertEqual(len(seen), 2 * len(one))

    def test_a_force(self):
        pushed, plain = drop(), drop()

        def push(view):
            view.velocities[:view.particles, 0] += 3 * view.dt

        pushed.add_hook("velocities_known", push)
        for world in (pushed, plain):
            for _ in range(5):
                world.step(0.01)
        change = pushed.velocities.mean(axis=0, dtype=float) - plain.velocities.mean(axis=0, dtype=float)
        np.testing.assert_allclose(change, (0.15, 0, 0), atol=1e-5)

    def test_an_exception_ends_the_step(self):
        world = drop()
        before, times = world.state_hash(), world.time

        def fail(view):
            if view.is_last:
                raise RuntimeError("no more")

        hook = world.add_hook("solved", fail)
        with self.assertRaisesRegex(RuntimeError, "no more"):
            world.step(0.01)
        self.assertEqual((world.state_hash(), world.time), (before, times))
        world.remove_hook(hook)
        world.step(0.01)
        other = drop()
        other.step(0.01)
        self.assertEqual(world.state_hash(), other.state_hash())

    def test_an_array_must_not_be_kept(self):
        for keep in (lambda view: view.positions, lambda view: view.slots[:5]):
            world, kept = drop(), []
            world.add_hook("solved", lambda view: kept.append(keep(view)))
            with self.assertRaisesRegex(ValueError, "solved.*keeps an array"):
                world.step(0.01)
            kept.clear()
        views, world = [], drop()
        world.add_hook("solved", views.append)
        world.step(0.01)
        with self.assertRaises(AttributeError):
            views[0].positions

    def test_a_traceback_keeps_no_array(self):
        def inner(view):
            positions = view.positions
            return positions.reshape(-1, 1)[0]["no field"]

        def fail(view):
            velocities, views[:] = view.velocities, [view]
            try:
                inner(view)
            except IndexError:
                raise RuntimeError(f"{len(velocities)} rows")

        world, views = drop(), []
        before = world.state_hash()
        world.add_hook("solved", fail)
        try:
            world.step(0.01)
        except RuntimeError as error:
            raised = error
        self.assertEqual(str(raised), f"{world.particle_count} rows")
        with self.assertRaises(AttributeError):
            views[0].positions
        seen = []
        for exception in (raised, raised.__context__):
            for frame, _ in traceback.walk_tb(exception.__traceback__):
                seen.append(frame.f_code.co_name)
                self.assertFalse({"positions", "velocities"} & set(frame.f_locals), seen)
        self.assertLessEqual({"fail", "inner"}, set(seen))
        self.assertEqual(world.state_hash(), before)

    def test_a_traceback_keeps_what_is_no_array(self):
        def fail(view):
            wanted = view.dt
            raise RuntimeError(wanted)

        world = drop()
        world.add_hook("solved", fail)
        try:
            world.step(0.01)
        except RuntimeError as error:
            last = list(traceback.walk_tb(error.__traceback__))[-1][0].f_locals
        self.assertAlmostEqual(last["wanted"], 0.005, places=6)
        with self.assertRaises(AttributeError):
            last["view"].positions

    def test_an_array_must_not_be_kept_by_who_raises(self):
        def fail(view):
            kept.append(view.positions)
            raise RuntimeError("no more")

        world, kept = drop(), []
        before = world.state_hash()
        world.add_hook("solved", fail)
        with self.assertRaisesRegex(ValueError, "solved.*keeps an array") as caught:
            world.step(0.01)
        self.assertIsInstance(caught.exception, meniscus.InvalidArgumentError)
        self.assertEqual(repr(caught.exception.__cause__), "RuntimeError('no more')")
        kept.clear()
        self.assertEqual(world.state_hash(), before)

    def test_no_call_of_the_world(self):
        world, refused = drop(), []

        def ask(view):
            try:
                world.positions
            except ValueError as error:
                refused.append(str(error))

        world.add_hook("predicted", ask)
        world.step(0.01)
        self.assertEqual(len(refused), 2)

    def test_refused(self):
        world = drop()
        with self.assertRaisesRegex(ValueError, "'predicted', .* not 'never'"):
            world.add_hook("never", print)
        with self.assertRaises(TypeError):
            world.add_hook("solved", 3)
        with self.assertRaises(TypeError):
            world.add_hook("solved", None)
        hook = world.add_hook("solved", print)
        world.remove_hook(hook)
        with self.assertRaises(KeyError):
            world.remove_hook(hook)


class Readers(unittest.TestCase):
    def test_files_from_python(self):
        asked = []

        def read(name):
            asked.append(name)
            return PLATE if name == "box.obj" else None

        world = drop(read_file=read)
        body = world.add_body(geometry=meniscus.MeshGeometry(file="box.obj"), density=500)
        self.assertAlmostEqual(body.volume, 1, places=4)
        self.assertIn("box.obj", asked)
        with self.assertRaises(OSError):
            world.add_shape(geometry=meniscus.MeshGeometry(file="other.obj"))
        asked.clear()
        self.assertAlmostEqual(world.clone().bodies[0].volume, 1, places=4)
        self.assertIn("box.obj", asked)

    def test_what_a_reader_raises(self):
        def fail(name):
            raise LookupError(name)

        world = drop(read_file=fail)
        with self.assertRaisesRegex(LookupError, "some.obj"):
            world.add_shape(geometry=meniscus.MeshGeometry(file="some.obj"))
        self.assertEqual(world.shapes, [])
        world.step(0.01)
        for wrong in (3, "box.obj"):
            with self.assertRaises(TypeError):
                meniscus.World(read_file=wrong)
        world = drop(read_file=lambda name: "text")
        with self.assertRaisesRegex(TypeError, "bytes or None"):
            world.add_shape(geometry=meniscus.MeshGeometry(file="some.obj"))

    def test_streams_are_of_gpus(self):
        for stream in (5, type("Stream", (), {"cuda_stream": 5})(), type("Stream", (), {"ptr": 5})(),
                       type("Stream", (), {"__cuda_stream__": lambda self: (0, 5)})()):
            with self.assertRaisesRegex(ValueError, "cuda_stream"):
                meniscus.World(device="cpu", cuda_stream=stream)
        with self.assertRaises(TypeError):
            meniscus.World(device="cpu", cuda_stream="main")


if __name__ == "__main__":
    unittest.main()
