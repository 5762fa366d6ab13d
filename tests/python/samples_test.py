# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Samples by Python end in the state of the command line. With --all: every sample, 30 frames. --device takes cpu or
cuda, by default cpu, and --only the samples whose names follow."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import meniscus

PROGRAM = os.environ.get("MENISCUS_PROGRAM")
SMALL = {"ropes": 30, "hanging_cloth": 30, "hourglass": 3, "belt": 3, "fountain": 2, "ball_in_sheet": 2, "cup_pour": 1}
FRAMES = 30


def options():
    parser = argparse.ArgumentParser()
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--device", default="cpu", choices=["cpu", "cuda"])
    parser.add_argument("--only", nargs="+", default=[])
    return parser.parse_known_args()


OPTIONS, OTHERS = options()


def chosen():
    if OPTIONS.only:
        return dict.fromkeys(OPTIONS.only, FRAMES)
    return dict.fromkeys(meniscus.sample_names(), FRAMES) if OPTIONS.all else SMALL


def by_command_line(scene, frames, folder):
    """A check of the scene may be broken, as most ask for more frames."""
    subprocess.run([PROGRAM, "run", scene, "--frames", str(frames), "--device", OPTIONS.device, "--out", folder,
                    "--quiet"], check=False, env={**os.environ, "LD_PRELOAD": ""}, stdout=subprocess.DEVNULL)
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())["state_hash"]


def by_python(scene, frames):
    world = meniscus.load_scene(scene, device=OPTIONS.device)
    world.run(frames)
    return f"{world.state_hash():016x}"


class Samples(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "the program is not built")
    def test_same_state(self):
        for scene, frames in chosen().items():
            with self.subTest(scene), tempfile.TemporaryDirectory() as folder:
                began = time.monotonic()
                found = by_python(scene, frames)
                seconds = time.monotonic() - began
                self.assertEqual(found, by_command_line(scene, frames, folder))
                if chosen() is not SMALL:
                    print(f"{scene}: {frames} frames, {found} by both, {seconds:.1f} s by Python", flush=True)

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
    unittest.main(argv=[sys.argv[0], *OTHERS])
