# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Classes and keyword arguments agree with the schema of scene files, which another visitor writes."""

import copy
import inspect
import json
import pickle
import re
import unittest

import meniscus

# Keys of files alone: names of alternatives, what stands for infinity, and files of hulls.
FILE_KEYS = {"type", "held", "angular_held", "unyielding", "copies", "motion_file"}
CALLS = {"fluids": "add_fluid", "granulars": "add_granular", "shapes": "add_shape", "bodies": "add_body",
         "cloths": "add_cloth", "ropes": "add_rope", "attachments": "add_attachment", "volumes": "add_volume",
         "emitters": "add_emitter", "sinks": "add_sink", "probes": "add_probe", "joints": "add_joint",
         "force_fields": "add_force_field"}


def schema():
    return json.loads(meniscus.scene_schema())["properties"]


def parameters(function):
    """The keyword arguments that a signature names."""
    text = function.__nb_signature__[0][0]
    return set(re.findall(r"[,*] (\w+):", text))


def alternatives(item):
    return item.get("oneOf", [item])


class Definitions(unittest.TestCase):
    def test_no_member_is_forgotten(self):
        checked = 0
        for key, call in CALLS.items():
            known = parameters(getattr(meniscus.World, call))
            for alternative in alternatives(schema()[key]["items"]):
                wanted = set(alternative["properties"]) - FILE_KEYS
                if key == "joints":  # the members of a kind are those of its class
                    wanted &= {"name", "a", "b", "frame", "bodies_collide"}
                self.assertLessEqual(wanted, known, call)
                checked += len(wanted)
        self.assertGreater(checked, 150)
        self.assertEqual(set(schema()["world"]["properties"]),
                         parameters(meniscus.World.__init__) - {"cuda_stream", "read_file", "log"})  # no plain values
        self.assertEqual(set(schema()["wind"]["properties"]), parameters(meniscus.World.set_wind))

    def test_no_alternative_is_forgotten(self):
        doc = meniscus.World.add_shape.__doc__
        texts = [a["description"] for a in schema()["shapes"]["items"]["properties"]["geometry"]["oneOf"]]
        self.assertGreaterEqual(len(texts), 9)
        for text in texts:
            self.assertIn(text, doc)

    def test_defaults_are_those_of_the_schema(self):
        world = meniscus.World(device="cpu")
        for key, member in schema()["world"]["properties"].items():
            if "default" not in member or key == "device":
                continue
            value = getattr(world, key)
            self.assertEqual(list(value) if isinstance(value, tuple) else value, member["default"], key)

    def test_docs_have_unit_and_range(self):
        doc = meniscus.World.add_fluid.__doc__
        self.assertIn("rest_density (kg/m³): density at rest; at least 0.001 and at most 1000000; default 1000.0",
                      doc)
        self.assertIn("rad", inspect.getdoc(meniscus.HingeJoint.lower))

    def test_members_of_a_world(self):
        world = meniscus.World(device="cpu", particle_spacing=0.1, gravity=(0, 0, -9.81),
                               density=meniscus.DensitySolverDef(solver="jacobi"))
        self.assertEqual((world.particle_spacing, world.gravity), (0.1, (0, 0, -9.81)))
        self.assertEqual(world.density.solver, "jacobi")
        world.density = world.density.replace(tolerance=0.01)
        world.substeps = 8
        self.assertEqual((world.density.tolerance, world.density.solver, world.substeps), (0.01, "jacobi", 8))
        with self.assertRaisesRegex(ValueError, "particle_spacing"):
            world.particle_spacing = 0.2
        self.assertEqual(world.particle_spacing, 0.1)

    def test_values(self):
        box = meniscus.BoxGeometry(half_extents=(1, 2, 3))
        self.assertEqual(repr(box), "BoxGeometry(half_extents=(1.0, 2.0, 3.0))")
        self.assertEqual(box, meniscus.BoxGeometry(half_extents=[1, 2, 3]))
        self.assertNotEqual(box, meniscus.BoxGeometry())
        self.assertNotEqual(box, 3)
        self.assertFalse(box == None)  # noqa: E711
        self.assertEqual([None, box].index(box), 1)
        self.assertEqual({box: 1}[meniscus.BoxGeometry(half_extents=(1, 2, 3))], 1)
        with self.assertRaises(AttributeError):
            box.half_extents = (1, 1, 1)
        fabric = meniscus.FabricDef(density=0.4, stretch_model="triangles")
        for same in (copy.copy(fabric), pickle.loads(pickle.dumps(fabric)), fabric.replace()):
            self.assertEqual(same, fabric)
        self.assertEqual(fabric.replace(density=1).stretch_model, "triangles")
        tank = meniscus.ContainerGeometry(openings=[meniscus.Opening(
            face="y_high", region=meniscus.Aabb(lower=(0, 0, 0), upper=(1, 1, 1)))])
        self.assertEqual(tank.openings[0].region.upper, (1, 1, 1))
        parts = meniscus.CompoundGeometry(parts=[{"geometry": box, "pose": (0, 1, 0)}])
        self.assertEqual(parts.parts[0].pose.position, (0, 1, 0))
        key = meniscus.Keyframe(time=1, position=(1, 2, 3))
        self.assertEqual((key.position, key.rotation), ((1, 2, 3), (0, 0, 0, 1)))

    def test_wrong_arguments(self):
        world = meniscus.World(device="cpu")
        for call, error, text in (
                (lambda: meniscus.World(spacing=1), TypeError, "no argument 'spacing'"),
                (lambda: meniscus.World(particle_spacng=1), TypeError, "did you mean \"particle_spacing\""),
                (lambda: meniscus.World(particle_spacing="wide"), TypeError, "particle_spacing must be a number"),
                (lambda: meniscus.World(substeps=1.5), TypeError, "substeps must be a whole number"),
                (lambda: meniscus.World(device="gpu"), ValueError, "'auto', 'cpu', 'cuda'"),
                (lambda: meniscus.World(device=3), TypeError, "one of 'auto'"),
                (lambda: meniscus.World(gravity=(0, 1)), TypeError, "gravity must be 3 numbers"),
                (lambda: meniscus.World(threads=2**40), ValueError, "threads"),
                (lambda: meniscus.World(particle_spacing=-1), ValueError, "particle_spacing"),
                (lambda: world.add_body(), TypeError, "needs the argument geometry"),
                (lambda: setattr(world, "frame_time", float("inf")), ValueError, "frame_time must be"),
                (lambda: setattr(world, "on_progress", 5), TypeError, "on_progress must be a function"),
                (lambda: world.run(-5), ValueError, "frames is -5"),
                (lambda: meniscus.axis_angle((float("inf"), 0, 0), 90), ValueError, "no direction"),
                (lambda: meniscus.axis_angle((0, 1, 0), float("nan")), ValueError, "no angle"),
                (lambda: world.save("here\0there"), ValueError, "NUL character: here"),
                (lambda: world.add_body(geometry=meniscus.PlaneGeometry()), TypeError, "one of BoxGeometry"),
                (lambda: world.add_body(geometry=meniscus.BoxGeometry(), density=-1), ValueError, "density"),
                (lambda: world.add_volume(fluid=3, region=meniscus.BoxRegion()), TypeError, "must be a Fluid"),
                (lambda: world.add_probe(kind="level", point=(0, 0, 0), radius=1, area=1), TypeError, "area"),
                (lambda: world.add_cloth(geometry=meniscus.SheetGeometry(), tethers=1), TypeError, "True or False")):
            with self.assertRaisesRegex(error, re.escape(text)):
                call()
        self.assertEqual(world.bodies, [])


if __name__ == "__main__":
    unittest.main()
