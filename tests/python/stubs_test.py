# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""mypy accepts the package, the example and right calls, and refuses wrong ones. Skipped without mypy."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import meniscus

GOOD = """
import meniscus
import numpy as np

world = meniscus.World(particle_spacing=0.1, device="cpu")
crate: meniscus.Body = world.add_body(geometry=meniscus.BoxGeometry(half_extents=(1, 1, 1)), pose=np.zeros(3))
x: float = crate.position[0]
crate.velocity = np.zeros(3)
total: float = float(world.positions.sum())
report: meniscus.StepReport = world.step()
hit = world.cast_ray((0, 0, 0), (1, 0, 0))
if hit is not None and hit.body is not None:
    hit.body.apply_force((1, 0, 0))
if hit is not None and hit.cloth is not None:
    print(hit.cloth.positions, hit.element)
place = world.nearest((0, 0, 0), reach=1, particles=False)
total += float(world.sample_fluid([(0, 0, 0)]).densities.sum())
events: list[meniscus.results.SleepEvent] = world.sleep_events()
frames: list[meniscus.Keyframe] = meniscus.read_keyframes(file="arm.tum")
replay = meniscus.Replay("run.menisrec")
again: meniscus.World = replay.start(threads=1, log=lambda level, text: print(level, text))
while (step := replay.next(again)) is not None:
    print(step.report.iterations, step.hash == step.recorded_hash)
try:
    meniscus.load_scene("dam_break")
except meniscus.FileError as error:
    print(error)
"""
BAD = ("meniscus.World(device='gpu')", "meniscus.World(spacing=1)", "meniscus.World().add_body()",
       "meniscus.World().time = 3", "meniscus.BoxGeometry().half_extents = (1, 1, 1)",
       "meniscus.World().step(dt='long')", "meniscus.World(log=lambda text: None)",
       "meniscus.World().nearest((0, 0, 0), 1, True)")


def mypy(*arguments):
    package = pathlib.Path(meniscus.__file__).parent
    # -P: what lies in the working folder is no module.
    return subprocess.run([sys.executable, "-P", "-m", "mypy", "--strict", "--no-error-summary", *map(str, arguments)],
                          capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(package.parent)},
                          cwd=tempfile.gettempdir())


class Stubs(unittest.TestCase):
    def test_stubs(self):
        with tempfile.TemporaryDirectory() as folder:
            good, bad = pathlib.Path(folder) / "good.py", pathlib.Path(folder) / "bad.py"
            good.write_text(GOOD)
            bad.write_text("import meniscus\n" + "\n".join(BAD) + "\n")
            example = pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"]) / "samples/python/pour.py"
            done = mypy("-p", "meniscus")
            self.assertEqual(done.stdout, "")
            done = mypy(good, example)
            self.assertEqual(done.stdout, "")
            refused = mypy(bad).stdout
            for line, text in enumerate(BAD, start=2):
                self.assertIn(f"bad.py:{line}: error", refused, text)


if __name__ == "__main__":
    if subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode != 0:
        sys.exit(77)
    unittest.main()
