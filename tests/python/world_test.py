# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""A world: lists of things, destruction, queries, pictures, errors, memory."""

import unittest

import meniscus
import numpy as np


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


def box(size=0.1):
    return meniscus.BoxGeometry(half_extents=(size, size, size))


class Things(unittest.TestCase):
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


class Worlds(unittest.TestCase):
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

    def test_falls_back_with_the_reason(self):
        gpu = next(device for device in meniscus.list_devices() if device.kind == "cuda")
        info = meniscus.World(particle_spacing=0.1).device_info
        self.assertEqual((info.kind, info.usable), ("cuda" if gpu.usable else "cpu", True))
        self.assertIn(gpu.reason, info.reason)
        if gpu.usable:
            self.assertEqual(info.reason, "")
            return
        self.assertNotEqual(gpu.reason, "")
        with self.assertRaises(meniscus.DeviceError) as caught:
            meniscus.World(device="cuda", particle_spacing=0.1)
        self.assertIn(gpu.reason, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
