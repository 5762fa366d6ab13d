# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Things in a world: creation, properties, forces, lists, destruction, queries, pictures."""

import math
import pathlib
import tempfile
import unittest

import meniscus
import numpy as np


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


def box(size=0.1):
    return meniscus.BoxGeometry(half_extents=(size, size, size))


class Bodies(unittest.TestCase):
    def test_falls_as_a_stone(self):
        world = empty(substeps=8)
        body = world.add_body(name="crate", geometry=box(), pose=(0, 10, 0), density=1000, can_sleep=False)
        self.assertAlmostEqual(body.mass, 8, places=4)
        self.assertAlmostEqual(body.volume, 0.008, places=6)
        for _ in range(60):
            world.step(1 / 60)
        self.assertAlmostEqual(world.time, 1, places=5)
        self.assertAlmostEqual(body.velocity[1], -9.81, delta=0.05)
        self.assertAlmostEqual(body.position[1], 10 - 9.81 / 2, delta=0.1)

    def test_set(self):
        world = empty(gravity=(0, 0, 0))
        body = world.add_body(geometry=box(), friction=0.5, mass=2)
        self.assertEqual(body.mass, 2)
        body.position = np.array([1, 2, 3])
        body.rotation = meniscus.axis_angle((0, 0, 2), 90)
        body.velocity = (1, 0, 0)
        body.angular_velocity = (0, 1, 0)
        self.assertEqual((body.position, body.velocity, body.angular_velocity), ((1, 2, 3), (1, 0, 0), (0, 1, 0)))
        np.testing.assert_allclose(body.rotation, (0, 0, math.sqrt(0.5), math.sqrt(0.5)), atol=1e-6)
        self.assertEqual(body.pose.position, (1, 2, 3))
        world.step(0.1)
        self.assertAlmostEqual(body.position[0], 1.1, places=4)

    def test_forces(self):
        world = empty(gravity=(0, 0, 0))
        body = world.add_body(geometry=box(), mass=2, can_sleep=False)
        body.apply_impulse((2, 0, 0))
        self.assertAlmostEqual(body.velocity[0], 1, places=5)
        body.apply_force((0, 20, 0))
        world.step(0.1)
        self.assertAlmostEqual(body.velocity[1], 1, places=4)
        body.apply_torque((0, 0, 1))
        world.step(0.1)
        self.assertAlmostEqual(body.angular_velocity[2], 0.1 / body.inertia[2], places=3)

    def test_kinematic(self):
        world = empty()
        cup = world.add_body(geometry=box(), motion="kinematic")
        cup.move_to((0, 1, 0), 0.1)
        world.step(0.1)
        self.assertAlmostEqual(cup.position[1], 1, places=5)
        with self.assertRaises(meniscus.InvalidArgumentError):
            cup.apply_force((1, 0, 0))
        turned = world.add_body(geometry=box(), motion="kinematic", loop=True, keyframes=[
            meniscus.Keyframe(time=0, position=(1, 0, 0)), {"time": 1, "position": (2, 0, 0)}])
        world.step(0.4)
        self.assertAlmostEqual(turned.position[0], 1.5, places=3)

    def test_surface_and_filter(self):
        world = empty()
        slope = world.add_shape(name="slope", geometry=box(2), pose=meniscus.Pose(
            position=(0, -2, 0), rotation=meniscus.axis_angle((0, 0, 1), -10)), solid_friction=0, friction=0.4)
        body = world.add_body(geometry=box(), pose=meniscus.Pose(
            position=(0.02, 0.14, 0), rotation=meniscus.axis_angle((0, 0, 1), -10)), can_sleep=False)
        self.assertAlmostEqual(slope.friction, 0.4)
        for _ in range(20):
            world.step(1 / 60)
        self.assertGreater(body.velocity[0], 0.3)  # slides, as there is no friction
        slope.solid_friction = 1
        body.solid_friction = 1
        for _ in range(60):
            world.step(1 / 60)
        self.assertLess(abs(body.velocity[0]), 0.05)
        self.assertAlmostEqual(slope.friction, 0.4)
        body.groups = 2
        slope.mask = 1
        self.assertEqual((body.groups, body.mask, slope.mask), (2, 0xffffffff, 1))
        for _ in range(10):
            world.step(1 / 60)
        self.assertLess(body.velocity[1], -1)  # falls through
        with self.assertRaisesRegex(ValueError, "restitution"):
            slope.restitution = 2
        self.assertEqual(slope.restitution, 0)

    def test_shape_pose(self):
        world = empty()
        floor = world.add_shape(name="floor", geometry=box(1), pose=(0, -1, 0))
        body = world.add_body(geometry=box(), pose=(0, 0.11, 0), can_sleep=False)
        world.step(1 / 60)
        floor.pose = (0, -3, 0)
        self.assertEqual((floor.position, floor.rotation), ((0, -3, 0), (0, 0, 0, 1)))
        self.assertAlmostEqual(world.cast_ray((0.5, 5, 0), (0.5, -9, 0)).distance, 7, places=3)
        for _ in range(20):
            world.step(1 / 60)
        self.assertLess(body.velocity[1], -2)
        floor.position = (1, -3, 0)
        floor.rotation = meniscus.axis_angle((0, 1, 0), 30)
        self.assertEqual(floor.pose.position, (1, -3, 0))
        floor.destroy()
        with self.assertRaises(meniscus.NotFoundError):
            floor.pose

    def test_lists_and_destruction(self):
        world = empty()
        a, b = (world.add_body(name=name, geometry=box(), pose=(x, 0, 0)) for name, x in (("a", 0), ("b", 1)))
        joint = world.add_joint(name="hinge", a=a, b=b, kind=meniscus.HingeJoint(lower=-1, upper=1))
        water = world.add_fluid()
        emitter = world.add_emitter(fluid=water, opening=meniscus.DiscOpening(), body=a)
        self.assertEqual((world.bodies, world.joints, world.emitters), ([a, b], [joint], [emitter]))
        self.assertEqual(world.body("b"), b)
        self.assertEqual({a: 1}[world.bodies[0]], 1)
        self.assertEqual(joint.angle, 0)
        with self.assertRaises(KeyError) as caught:
            world.body("c")
        self.assertEqual(str(caught.exception), 'the world has no body named "c"')
        a.destroy()
        self.assertEqual((world.bodies, world.joints, world.emitters), ([b], [], []))
        self.assertEqual((a.name, b.name, repr(a)), ("", "b", "<Body, destroyed>"))
        with self.assertRaises(meniscus.NotFoundError):
            a.position
        with self.assertRaises(meniscus.NotFoundError):
            a.destroy()

    def test_foreign_things_are_refused(self):
        body = empty().add_body(geometry=box())
        with self.assertRaises(meniscus.NotFoundError):
            empty().add_joint(a=body)

    def test_contacts_rays_overlaps(self):
        world = empty()
        floor = world.add_shape(name="floor", geometry=meniscus.PlaneGeometry())
        body = world.add_body(geometry=box(), pose=(0, 0.11, 0))
        events = []
        for _ in range(30):
            world.step(1 / 60)
            events += world.contact_events()
        self.assertEqual([(e.a, e.shape, e.began) for e in events][:1], [(body, floor, True)])
        contact = world.solid_contacts()[0]
        self.assertEqual((contact.a, contact.shape), (body, floor))
        self.assertAlmostEqual(sum(c.impulse for c in world.solid_contacts()),
                               body.mass * 9.81 / 60 / world.substeps, delta=0.02)
        hit = world.cast_ray((0, 1, 0), (0, -1, 0))
        self.assertEqual((hit.body, hit.shape, hit.particle), (body, None, None))
        self.assertAlmostEqual(hit.distance, 0.8, delta=0.02)
        self.assertIsNone(world.cast_ray((5, 1, 0), (5, 0.5, 0)))
        self.assertEqual(world.overlap_ball((0, 0.2, 0), 0.1).bodies, [body])
        self.assertEqual(world.overlap_box((3, 0.5, 0), (0.1, 0.1, 0.1)).bodies, [])
        np.testing.assert_allclose(world.solid_distances([(2, 0.5, 0), (2, 9, 0)], 1), [0.5, 1], atol=1e-3)


class Others(unittest.TestCase):
    def test_water(self):
        world = empty()
        tank = world.add_shape(name="tank", geometry=meniscus.ContainerGeometry(half_extents=(0.5, 0.5, 0.5)))
        water = world.add_fluid(name="water", xsph=20)
        count = world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-0.5, -0.5, -0.5), upper=(0.5, 0, 0.5)))
        self.assertEqual(count, world.particle_count)
        weight = world.add_probe(kind="wall_force", shape=tank)
        level = world.add_probe(kind="level", point=(0, -0.5, 0), radius=0.2)
        for _ in range(60):
            report = world.step(1 / 60)
        self.assertEqual(report.substeps, 4)
        self.assertGreater(report.contacts, 100)
        self.assertEqual(set(report.stage_ms), {"predict", "neighbours", "contacts", "solve", "velocity", "exchange",
                                                "finish"})
        self.assertIn("substeps=4", repr(report))
        self.assertAlmostEqual(weight.vector[1] / (-9.81 * count * water.particle_mass), 1, delta=0.25)
        self.assertAlmostEqual(level.value, 0.5, delta=0.1)
        figures = world.diagnostics()
        self.assertEqual((figures.particles, figures.outside, figures.non_finite), (count, 0, 0))
        self.assertEqual(water.xsph, 20)
        water.xsph = 30
        self.assertEqual(world.fluid("water").xsph, 30)
        with self.assertRaises(ValueError):
            water.rest_density = 5
        contacts = world.particle_contacts()
        self.assertEqual(set(contacts.shapes), {0})
        self.assertEqual(set(contacts.bodies), {-1})
        mesh = world.surface_mesh(cell_size=1)
        self.assertGreater(len(mesh.triangles), 100)
        self.assertEqual(mesh.triangles.max(), len(mesh.vertices) - 1)
        world.remove_particles(world.ids)
        self.assertEqual(world.particle_count, 0)

    def test_cloth_and_rope(self):
        world = empty()
        cloth = world.add_cloth(name="sheet", geometry=meniscus.SheetGeometry(columns=5, rows=5),
                                fabric={"density": 0.5})
        held = world.add_attachment(cloth=cloth, vertices=[0, 4, 20, 24])
        rope = world.add_rope(points=[(0, 0, 2), (1, 0, 2)], segments=4, bends_and_twists=True)
        self.assertEqual((cloth.positions.shape, cloth.triangles.shape), ((25, 3), (32, 3)))
        self.assertEqual((rope.positions.shape, rope.frames.shape), ((5, 3), (4, 4)))
        self.assertAlmostEqual(cloth.state.mass, 0.5, places=5)
        self.assertEqual(held.vertices, [0, 4, 20, 24])
        corners = cloth.positions[held.vertices].copy()
        for _ in range(30):
            world.step(1 / 60)
        np.testing.assert_allclose(cloth.positions[held.vertices], corners, atol=1e-5)
        self.assertLess(cloth.positions[12, 1], -0.01)
        self.assertLess(rope.positions[2, 1], -1)
        self.assertGreater(cloth.strains.max(), 0)
        cloth.apply_impulses([12], [(0, 1, 0)])
        self.assertGreater(cloth.velocities[12, 1], 1)
        cloth.destroy()
        self.assertEqual((world.cloths, world.attachments), ([], []))

    def test_flow(self):
        world = empty()
        sand = world.add_granular(name="sand")
        emitter = world.add_emitter(fluid=sand, opening=meniscus.DiscOpening(radius=0.2), speed=1, pose=(0, 1, 0))
        sink = world.add_sink(region=meniscus.HalfSpaceRegion(offset=0.5))
        for _ in range(60):
            world.step(1 / 60)
        self.assertGreater(emitter.total, 20)
        self.assertEqual(emitter.total - sink.total, world.particle_count)
        with self.assertRaises(AttributeError):
            sand.xsph

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

    def test_vectors_of_a_fluid(self):
        world = empty()
        water, oil = world.add_fluid(name="water"), world.add_fluid(name="oil")
        world.add_particles(water, [(0, 0, 0), (1, 0, 0)])
        world.add_particles(oil, [(2, 0, 0)])
        oil.set_positions([(3, 0, 0)])
        water.set_velocities([(1, 0, 0), (2, 0, 0)])
        np.testing.assert_array_equal(world.positions[:, 0], [0, 1, 3])
        np.testing.assert_array_equal(world.velocities[:, 0], [1, 2, 0])
        with self.assertRaises(ValueError):
            oil.set_positions([])
        sand = world.add_granular(name="sand")
        sand.mask = 4
        self.assertEqual((sand.groups, sand.mask), (1, 4))
        with self.assertRaises(AttributeError):
            sand.xsph

    def test_pictures(self):
        world = empty()
        world.add_shape(geometry=meniscus.PlaneGeometry())
        world.add_body(geometry=box(0.5), pose=(0, 0.5, 0))
        world.add_cloth(geometry=meniscus.SheetGeometry(columns=3, rows=3), pose=(0, 1.5, 0))
        picture = world.show(width=64, height=48, position=(3, 2, 3))
        self.assertEqual((picture.pixels.shape, picture.pixels.dtype), ((48, 64, 3), np.uint8))
        self.assertGreater(np.unique(picture.pixels.reshape(-1, 3), axis=0).shape[0], 50)
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        with self.assertRaises(ValueError):
            world.draw(width=0)

    def test_errors(self):
        world = empty()
        self.assertTrue(issubclass(meniscus.OutOfMemoryError, MemoryError))
        mesh = meniscus.MeshGeometry(file="/nowhere/mesh.obj")
        with self.assertRaises(OSError) as caught:
            world.add_shape(geometry=mesh)
        self.assertIsInstance(caught.exception, meniscus.Error)
        self.assertIn("/nowhere/mesh.obj", str(caught.exception))
        with self.assertRaises(meniscus.FileError):
            meniscus.load_scene("no_such_sample")
        with self.assertRaises(ValueError):
            meniscus.load_scene("dam_break", overrides=["world.substeps=many"])
        self.assertEqual(world.shapes, [])

    def test_devices_and_memory(self):
        world = empty()
        self.assertEqual(world.device_info.kind, "cpu")
        self.assertIn("cpu", [device.kind for device in meniscus.list_devices()])
        self.assertEqual(sum(world.memory().values()), world.device_bytes)
        self.assertEqual(world.warnings(), [])


if __name__ == "__main__":
    unittest.main()
