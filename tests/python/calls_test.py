# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Every public call and class has a docstring, and no call of World is missing."""

import os
import pathlib
import re
import unittest

import meniscus

# What Python calls otherwise. None is what belongs to C++ alone: constructors, the lifetime of read-outs, and memory of
# a renderer.
RENAMED = {"def": "gravity", "set_def": "gravity", "device": "device_info", "set_fluid": ("Fluid", "xsph"),
           "fluids": "fluid_indices",
           "set_cloth_positions": ("Cloth", "positions"), "set_cloth_velocities": ("Cloth", "velocities"),
           "set_rope_positions": ("Rope", "positions"), "set_rope_velocities": ("Rope", "velocities"),
           "set_shape_pose": ("Shape", "pose"), "set_filter": ("Rope", "mask"), "set_surface": ("Shape", "friction"),
           "body_ids": "bodies",
           "create_fluid": "add_fluid", "add_fluid": "add_volume", "set_progress": "on_progress",
           "memory_shares": "memory", "write_particles": None, "hold": None, "World": None,
           "set_force_field": ("ForceField", "force"),
           "destroy_force_field": ("ForceField", "destroy"),
           "emitter_count": ("Emitter", "total"), "emitter_pressure": ("Emitter", "pressure"),
           "sink_count": ("Sink", "total"),
           "particle_mass": ("Fluid", "particle_mass"), "hinge_angle": ("Joint", "angle"),
           "probe": ("Probe", "value"), "probe_vector": ("Probe", "vector"), "body_state": ("Body", "velocity"),
           "body_mass": ("Body", "mass"), "set_body_pose": ("Body", "pose"), "move_body": ("Body", "move_to"),
           "set_body_velocity": ("Body", "velocity"), "apply_force": ("Body", "apply_force"),
           "apply_torque": ("Body", "apply_torque"), "apply_impulse": ("Body", "apply_impulse"), "operator": None}


def counterpart(name):
    """The class and the member of Python for a call of C++."""
    if name in RENAMED:
        target = RENAMED[name]
        return ("World", target) if isinstance(target, str) else target
    if name == "find_cloth":
        return "World", name
    if name.endswith("_ids"):
        return "World", name.removesuffix("_ids") + "s"
    for prefix, kind in (("cloth_", "Cloth"), ("rope_", "Rope"), ("attachment_", "Attachment")):
        if name.startswith(prefix):
            return kind, name.removeprefix(prefix)
    if name.startswith("find_"):
        return "World", name.removeprefix("find_")
    if name.startswith("destroy_"):
        return name.removeprefix("destroy_").capitalize(), "destroy"
    return "World", name.replace("create_", "add_")


class Calls(unittest.TestCase):
    def test_no_call_is_missing(self):
        header = (pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"]) / "sdk/include/meniscus/world.h").read_text()
        public = re.sub(r"//.*", "", header[header.index(" public:"):header.index(" private:")])
        names = set(re.findall(r"(\w+)\s*\([^()]*(?:\([^()]*\)[^()]*)*\)\s*(?:const|noexcept)?\s*;", public))
        self.assertGreater(len(names), 70)
        for name in names:
            target = counterpart(name)
            if target:
                self.assertTrue(hasattr(getattr(meniscus, target[0]), target[1]), f"{name}: {target}")
            if name.startswith("find_"):
                self.assertTrue(callable(getattr(meniscus.World, target[1])), name)

    def test_all_is_documented(self):
        checked = 0
        for name in meniscus.__all__:
            thing = getattr(meniscus, name)
            if not isinstance(thing, type):
                continue
            for member, value in vars(thing).items():
                if member.startswith("_"):
                    continue
                self.assertTrue(getattr(value, "__doc__", None), f"{name}.{member}")
                checked += 1
        self.assertGreater(checked, 250)


if __name__ == "__main__":
    unittest.main()
