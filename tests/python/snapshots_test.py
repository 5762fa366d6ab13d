# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Snapshots, files and clones of worlds."""

import pathlib
import tempfile
import unittest

import meniscus
import numpy as np

COUNTS = pathlib.Path("/proc/self/io")


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


def box(size=0.1):
    return meniscus.BoxGeometry(half_extents=(size, size, size))


class Snapshots(unittest.TestCase):
    def test_snapshots(self):
        world = empty()
        world.add_shape(geometry=meniscus.PlaneGeometry())
        water = world.add_fluid(name="water")
        world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(0.3, 0.3, 0.3)))
        world.step(0.02)
        snapshot = world.snapshot()
        self.assertEqual(snapshot.time, world.time)
        before = world.state_hash()
        world.step(0.02)
        after = world.state_hash()
        world.add_fluid(name="oil")
        world.restore(snapshot)
        self.assertEqual((world.state_hash(), [fluid.name for fluid in world.fluids]), (before, ["water"]))
        world.step(0.02)
        self.assertEqual(world.state_hash(), after)
        world.add_body(geometry=box(0.1), pose=(1, 1, 1))
        world.restore(snapshot)
        self.assertEqual((world.state_hash(), len(world.bodies)), (before, 0))
        with self.assertRaises(ValueError):
            empty().restore(snapshot)


def looks(world):
    """What a snapshot did not have once."""
    sand = world.fluid("sand")
    return tuple(world.fluid("syrup").color), sand.friction, sand.density


class Files(unittest.TestCase):
    def full(self):
        """A world with a thing of each kind."""
        world = empty()
        world.add_shape(name="floor", geometry=meniscus.PlaneGeometry(), pose=(0, -1, 0), friction=0.3)
        water = world.add_fluid(name="water", xsph=10)
        world.add_granular(name="sand")
        world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(0.3, 0.3, 0.3)))
        body = world.add_body(name="crate", geometry=box(0.1), pose=(1, 0, 0))
        world.add_joint(name="hinge", a=body, kind=meniscus.HingeJoint())
        cloth = world.add_cloth(name="sheet", geometry=meniscus.SheetGeometry(columns=4, rows=4), pose=(2, 1, 0))
        world.add_attachment(name="nail", cloth=cloth, vertices=[0])
        world.add_rope(name="rope", points=[(3, 1, 0), (4, 1, 0)], segments=3)
        world.add_emitter(name="tap", fluid=water, opening=meniscus.DiscOpening(), pose=(0, 2, 0), speed=1)
        world.add_sink(name="drain", region=meniscus.HalfSpaceRegion(offset=-0.9))
        world.add_probe(name="gauge", kind="level", point=(0, -1, 0), radius=0.2)
        world.add_force_field(name="wind", force=meniscus.UniformForce(value=(1, 0, 0)))
        gone = world.add_body(geometry=box(0.1), pose=(9, 0, 0))
        gone.destroy()
        world.step(0.01)
        return world

    def test_files_and_clones(self):
        kinds = ("fluids", "shapes", "bodies", "joints", "cloths", "ropes", "attachments", "emitters", "sinks", "probes",
                 "force_fields")
        world = self.full()
        world.add_body(name="second", geometry=box(0.1), pose=(5, 0, 0))  # takes the place of the one that went
        names = {kind: [thing.name for thing in getattr(world, kind)] for kind in kinds}
        self.assertTrue(all(names.values()))
        clone = world.clone()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "state.meniscus"
            world.save(path)
            loaded = meniscus.World.load(path, device="cpu", threads=2)
            path.write_bytes(path.read_bytes()[:-3])
            with self.assertRaises(OSError):
                meniscus.World.load(path)
        hashes = []
        for other in (world, clone, loaded):
            for kind in kinds:
                self.assertEqual([thing.name for thing in getattr(other, kind)], names[kind], kind)
            crate = other.body("crate")
            crate.velocity = (0, 1, 0)
            self.assertAlmostEqual(other.shape("floor").friction, 0.3)
            other.shape("floor").friction = 0.1
            other.fluid("water").xsph = 12
            other.find_cloth("sheet").velocities = np.ones((16, 3))
            other.joint("hinge").destroy()
            other.step(0.01)
            other.run(2, 0.01)
            hashes.append(other.state_hash())
            self.assertEqual(other.draw(32, 24).shape, (24, 32, 3))
        self.assertEqual(hashes[1:], hashes[:1] * 2)
        self.assertEqual(loaded.threads, 2)
        with self.assertRaises(meniscus.NotFoundError):
            world.add_joint(a=clone.body("crate"))

    def test_colours(self):
        world = empty()
        red, grey = (0.75, 0.125, 0.0), (0.5, 0.5, 0.25)
        world.add_shape(geometry=meniscus.PlaneGeometry())
        syrup = world.add_fluid(name="syrup", color=red)
        world.add_volume(fluid=syrup, region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(0.3, 0.3, 0.3)))
        sand = world.add_granular(name="sand", color=grey, friction=0.1)
        world.add_particles(sand, [(0.5, 0.1, 0.1)])
        world.add_cloth(name="sheet", geometry=meniscus.SheetGeometry(columns=4, rows=4), pose=(0, 1, 0), color=grey)
        world.add_rope(name="rope", points=[(0, 0.5, 0), (1, 0.5, 0)], segments=3, color=red)
        syrup.color = red[::-1]
        expected = looks(world)
        self.assertEqual(expected[0], red[::-1])
        self.assertAlmostEqual(expected[1], 0.1)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "state.menisnap"
            world.save(path)
            loaded = meniscus.World.load(path)
            loaded.save(path)
            again = meniscus.World.load(path)
        for other in (world.clone(), loaded, again):
            self.assertEqual(looks(other), expected)
            np.testing.assert_array_equal(other.draw(64, 36), world.draw(64, 36))

    @unittest.skipUnless(COUNTS.exists(), "Linux counts the bytes that a process reads")
    def test_a_file_is_read_once(self):
        def bytes_read():
            return int(COUNTS.read_text().split("rchar: ")[1].split()[0])

        world = empty()
        world.add_volume(fluid=world.add_fluid(), region=meniscus.BoxRegion(lower=(0, 0, 0), upper=(2, 2, 2)))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "state.meniscus"
            world.save(path)
            before = bytes_read()
            loaded = meniscus.World.load(path)
            taken = bytes_read() - before
            self.assertGreater(path.stat().st_size, 200_000)
            self.assertLess(taken, 1.2 * path.stat().st_size)
            self.assertEqual(loaded.state_hash(), world.state_hash())


if __name__ == "__main__":
    unittest.main()
