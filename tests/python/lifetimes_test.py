# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""How long worlds live, and the functions that they call."""

import gc
import pathlib
import tempfile
import unittest
import weakref

import meniscus
import numpy as np

TETRAHEDRON = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


class Function:
    """Takes all arguments that a world gives."""

    def __call__(self, *arguments):
        return TETRAHEDRON


def world_with(function, kind):
    """A world that calls a function, as this kind."""
    members = {kind: function} if kind in ("read_file", "log") else {}
    world = meniscus.World(particle_spacing=0.1, substeps=1, iterations=2, device="cpu", threads=1, **members)
    if kind == "hook":
        world.add_hook("solved", function)
    if kind == "on_progress":
        world.on_progress = function
    return world


KINDS = ("hook", "on_progress", "read_file", "log")


class Lifetimes(unittest.TestCase):
    def check_gone(self, kind, refer):
        """With a function that has `refer(world)`, nothing is left once nobody holds the world."""
        function = Function()
        world = world_with(function, kind)
        function.held = refer(world)
        world.step(0.01)
        gone = weakref.ref(function)
        del function, world
        gc.collect()
        self.assertIsNone(gone(), kind)

    def test_the_function_is_let_go(self):
        function = Function()
        gone, world = weakref.ref(function), world_with(function, None)
        hook = world.add_hook("solved", function)
        del function
        self.assertIsNotNone(gone())
        world.step(0.01)
        world.remove_hook(hook)
        self.assertIsNone(gone())

    def test_a_function_that_holds_its_world(self):
        for kind in KINDS:
            self.check_gone(kind, lambda world: world)

    def test_a_function_that_holds_a_thing(self):
        for kind in KINDS:
            self.check_gone(kind, lambda world: world.add_fluid())

    def test_a_function_that_holds_an_array(self):
        for kind in KINDS:
            self.check_gone(kind, lambda world: world.device_arrays().positions)

    def test_a_function_that_holds_all(self):
        for kind in KINDS:
            self.check_gone(kind, lambda world: (world, world.clone(), world.add_fluid(), world.device_arrays()))

    def test_a_thing_outlives_the_world(self):
        function = Function()
        gone, world = weakref.ref(function), world_with(function, "hook")
        cloth = world.add_cloth(geometry=meniscus.SheetGeometry(columns=3, rows=3))
        world.step(0.01)
        before = cloth.positions.copy()
        del function, world
        self.assertIsNone(gone())
        np.testing.assert_array_equal(cloth.positions, before)
        cloth.positions = before + 1
        np.testing.assert_array_equal(cloth.positions, before + 1)

    def check_clone_keeps(self, kind, use):
        """A clone has the function once its world has gone, and frees it with itself."""
        function = Function()
        gone, world = weakref.ref(function), world_with(function, kind)
        clone = world.clone()
        del function, world
        gc.collect()
        self.assertIsNotNone(gone(), kind)
        use(clone)
        gone().clone = clone
        del clone
        gc.collect()
        self.assertIsNone(gone(), kind)

    def test_a_clone_keeps_the_reader(self):
        self.check_clone_keeps("read_file", lambda clone: clone.add_shape(geometry=meniscus.MeshGeometry(file="any.obj")))

    def test_a_clone_keeps_the_log(self):
        self.check_clone_keeps("log", lambda clone: clone.step(0.01))

    def test_worlds_from_files_and_recordings(self):
        with tempfile.TemporaryDirectory() as folder:
            saved, recorded = pathlib.Path(folder) / "world.menis", pathlib.Path(folder) / "run.menisrec"
            world = world_with(None, None)
            world.save(saved)
            world.start_recording(recorded)
            world.step(0.01)
            world.stop_recording()
            sources = [("file", lambda **given: meniscus.World.load(saved, **given)),
                       ("recording", lambda **given: meniscus.Replay(recorded).start(**given))]
            for source, make in sources:
                for kind in ("read_file", "log"):
                    function = Function()
                    function.held, gone = make(**{kind: function}), weakref.ref(function)
                    gc.collect()
                    self.assertIsNotNone(gone(), (source, kind))
                    del function
                    gc.collect()
                    self.assertIsNone(gone(), (source, kind))


if __name__ == "__main__":
    unittest.main()
