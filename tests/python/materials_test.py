# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Fluids, grains, cloth and ropes: creation, properties, arrays, flow."""

import unittest

import meniscus
import numpy as np


def empty(**members):
    return meniscus.World(device="cpu", threads=1, particle_spacing=0.1, **members)


class Particles(unittest.TestCase):
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


class Pieces(unittest.TestCase):
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


if __name__ == "__main__":
    unittest.main()
