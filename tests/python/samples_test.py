# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Samples by Python end in the state of the command line. With --all: every sample, 30 frames."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import meniscus

PROGRAM = os.environ.get("MENISCUS_PROGRAM")
SMALL = {"ropes": 5, "hanging_cloth": 5, "hourglass": 3, "belt": 3, "fountain": 2, "ball_in_sheet": 2, "cup_pour": 1}
ALL = {"dam_break": 2, "cup_pour": 2, "floating_crates": 2, "ropes": 3, "hanging_cloth": 3, "fountain": 3,
         "hourglass": 2}
ALL = "--all" in sys.argv


def by_command_line(scene, frames, folder):
    subprocess.run([PROGRAM, "run", scene, "--frames", str(frames), "--device", "cpu", "--out", folder, "--quiet"],
                   check=False, env={**os.environ, "LD_PRELOAD": ""}, stdout=subprocess.DEVNULL)
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())["state_hash"]


def by_python(scene, frames):
    world = meniscus.load_scene(scene, device="cpu")
    world.run(frames)
    return f"{world.state_hash():016x}"


class Samples(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "the program is not built")
    def test_same_state(self):
        scenes = {name: 30 for name in meniscus.sample_names()} if ALL else SMALL
        self.assertGreaterEqual(len(scenes), 7)
        for scene, frames in scenes.items():
            with self.subTest(scene), tempfile.TemporaryDirectory() as folder:
                self.assertEqual(by_python(scene, frames), by_command_line(scene, frames, folder))

    def test_command(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "last.png"
            done = subprocess.run([sys.executable, "-m", "meniscus", "run", "hanging_cloth", "--frames", "2",
                                   "--device", "cpu", "--set", "world.substeps=2", "--picture", str(picture)],
                                  capture_output=True, text=True, check=True)
            self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        result = json.loads(done.stdout)
        self.assertEqual((result["scene"], result["frames"]), ("hanging_cloth", 2))
        self.assertEqual(len(result["state_hash"]), 16)
        wrong = subprocess.run([sys.executable, "-m", "meniscus", "run", "hangig_cloth"],
                               capture_output=True, text=True)
        self.assertEqual((wrong.returncode, wrong.stdout), (1, ""))
        self.assertIn("no sample is called 'hangig_cloth'", wrong.stderr)

    def test_scene(self):
        world = meniscus.load_scene("floating_crates", device="cpu")
        self.assertGreater(len(world.bodies), 1)
        self.assertEqual(world.body(world.bodies[1].name), world.bodies[1])
        self.assertGreater(world.frames, 1)
        self.assertGreater(world.fluids[0].rest_density, 0)


if __name__ == "__main__":
    unittest.main(argv=[argument for argument in sys.argv if argument != "--all"])
