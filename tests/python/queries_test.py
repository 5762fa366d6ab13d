# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Rays, overlaps, the nearest place, the fluid at points, and events of sleep and flow."""

import unittest

import meniscus
import numpy as np

KINDS = ("solids", "particles", "cloth", "ropes")


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


def only(kind):
    return {name: name == kind for name in KINDS}


class Layers(unittest.TestCase):
    """A floor, a particle above it, cloth above that, a rope above all, and a ball beside them."""

    def setUp(self):
        self.world = world = empty()
        self.floor = world.add_shape(geometry=meniscus.PlaneGeometry())
        world.add_particles(world.add_fluid(), [(0, 0.5, 0)])
        self.cloth = world.add_cloth(geometry=meniscus.SheetGeometry(width=1, depth=1, columns=5, rows=5),
                                     pose=(0, 1, 0))
        self.rope = world.add_rope(points=[(-1, 2, 0), (1, 2, 0)], segments=4, radius=0.1)
        self.ball = world.add_body(geometry=meniscus.SphereGeometry(radius=0.25), pose=(3, 1, 0))

    def test_rays(self):
        targets = dict.fromkeys(KINDS, True)
        found = []
        for kind in ("ropes", "cloth", "particles", "solids"):
            hit = self.world.cast_ray((0.01, 5, 0.02), (0.01, -1, 0.02), **targets)
            found.append((hit.rope, hit.cloth, hit.particle, hit.shape))
            self.assertAlmostEqual(hit.distance, 5 - hit.point[1], places=5)
            self.assertEqual(hit.element is None, kind in ("particles", "solids"))
            if kind == "ropes":
                self.assertEqual(hit.element, 2)
            if kind == "cloth":
                corners = self.cloth.positions[self.cloth.triangles[hit.element]]
                self.assertLess(np.linalg.norm(corners.mean(axis=0) - hit.point), 0.25)
            targets[kind] = False
        self.assertEqual(found, [(self.rope, None, None, None), (None, self.cloth, None, None), (None, None, 0, None),
                                 (None, None, None, self.floor)])
        self.assertIsNone(self.world.cast_ray((0.01, 5, 0.02), (0.01, -1, 0.02), **targets))
        self.assertEqual(self.world.cast_ray((0.01, 5, 0.02), (0.01, -1, 0.02)).rope, self.rope)

    def test_nearest(self):
        world = self.world
        place = world.nearest((0, 1.3, 0.1), 10, **only("solids"))
        self.assertEqual((place.shape, place.body, place.element), (self.floor, None, None))
        np.testing.assert_allclose(place.point, (0, 0, 0.1), atol=1e-5)
        self.assertAlmostEqual(place.distance, 1.3, places=5)
        place = world.nearest((3, 1.1, 0), 10)
        self.assertEqual(place.body, self.ball)
        self.assertAlmostEqual(place.distance, -0.15, places=5)
        place = world.nearest((0.1, 0.5, 0), 10, **only("particles"))
        self.assertEqual(place.particle, 0)
        self.assertAlmostEqual(place.distance, 0.05, places=5)
        place = world.nearest((0.8, 1.4, 0), 10, **only("cloth"))
        self.assertEqual(place.cloth, self.cloth)
        np.testing.assert_allclose(place.normal, (0.6, 0.8, 0), atol=1e-4)
        place = world.nearest((1.4, 2, 0), 10, **only("ropes"))
        self.assertEqual((place.rope, place.element), (self.rope, 3))
        self.assertIsNone(world.nearest((0, 1.7, 0), 0.1))
        with self.assertRaises(ValueError):
            world.nearest((0, 0, 0), -1)
        with self.assertRaisesRegex(TypeError, "point"):
            world.nearest("there", 1)

    def test_overlaps(self):
        found = self.world.overlap_box((0, 1.5, 0), (4, 2, 4))
        self.assertEqual((found.bodies, found.shapes, list(found.particles), found.cloths, found.ropes),
                         ([self.ball], [self.floor], [0], [self.cloth], [self.rope]))
        found = self.world.overlap_box((0, 1.5, 0), (4, 2, 4), **only("ropes"))
        self.assertEqual((found.bodies, found.shapes, list(found.particles), found.cloths, found.ropes),
                         ([], [], [], [], [self.rope]))
        found = self.world.overlap_ball((0, 1.1, 0), 0.2)
        self.assertEqual((found.bodies, found.shapes, found.cloths, found.ropes), ([], [], [self.cloth], []))
        self.assertEqual(self.world.overlap_ball((0, 1.1, 0), 0.2, cloth=False).cloths, [])


class Fluids(unittest.TestCase):
    def test_samples(self):
        world = empty()
        water, oil = world.add_fluid(), world.add_fluid(rest_density=500)
        world.add_volume(fluid=water, region=meniscus.BoxRegion(lower=(-1, -1, -1), upper=(1, 1, 1)),
                         velocity=(1, 2, 3))
        sample = world.sample_fluid([(0, 0, 0), (9, 9, 9)])
        self.assertEqual((sample.densities.shape, sample.velocities.shape), ((2,), (2, 3)))
        self.assertAlmostEqual(sample.densities[0] / 1000, 1, delta=0.03)
        np.testing.assert_allclose(sample.velocities, [(1, 2, 3), (0, 0, 0)], atol=1e-5)
        self.assertGreater(sample.particles[0], 20)
        self.assertEqual((sample.densities[1], sample.particles[1]), (0, 0))
        self.assertFalse(sample.densities.flags.writeable)
        self.assertEqual(world.sample_fluid([(0, 0, 0)], fluid=oil).particles[0], 0)
        self.assertEqual(world.sample_fluid([(0, 0, 0)], water).particles[0], sample.particles[0])
        self.assertEqual(world.sample_fluid([]).densities.shape, (0,))

    def test_flow_events(self):
        world = empty()
        water = world.add_fluid()
        emitter = world.add_emitter(fluid=water, opening=meniscus.DiscOpening(radius=0.2), speed=2, pose=(0, 1, 0))
        sink = world.add_sink(region=meniscus.HalfSpaceRegion(offset=0.5))
        there, gone = set(), 0
        for _ in range(60):
            world.step(1 / 60)
            events = world.flow_events()
            made = events.particles[events.emitters == 0]
            taken = events.particles[events.sinks == 0]
            self.assertEqual((len(made), len(taken)), (emitter.last_step, sink.last_step))
            self.assertEqual(len(made) + len(taken), len(events.particles))
            there = (there | set(made)) - set(taken)
            gone += len(taken)
            self.assertTrue(len(events.particles) == 0 or not events.particles.flags.writeable)
            self.assertEqual(there, set(world.ids))
        self.assertGreater(gone, 0)

    def test_sleep_events(self):
        world = empty()
        world.add_shape(geometry=meniscus.PlaneGeometry())
        body = world.add_body(geometry=meniscus.BoxGeometry(half_extents=(0.1, 0.1, 0.1)), pose=(0, 0.1, 0))
        events = []
        for _ in range(200):
            world.step(0.02)
            events += world.sleep_events()
            if events:
                break
        self.assertEqual([(event.body, event.awake) for event in events], [(body, False)])
        body.apply_impulse((0, 1, 0))
        world.step(0.02)
        self.assertEqual([(event.body, event.awake) for event in world.sleep_events()], [(body, True)])
        world.step(0.02)
        self.assertEqual(world.sleep_events(), [])


if __name__ == "__main__":
    unittest.main()
