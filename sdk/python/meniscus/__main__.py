# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""python -m meniscus: runs scenes, and lists samples and devices."""

from __future__ import annotations

import argparse
import json
import sys

from . import __version__, list_devices, load_scene, sample_names
from .errors import Error
from .runs import steps


def run(options: argparse.Namespace) -> None:
    world = load_scene(options.scene, device=options.device, threads=options.threads, overrides=options.set)
    for warning in world.warnings():
        print(f"meniscus: warning: {warning}", file=sys.stderr)
    frames = world.frames if options.frames is None else options.frames
    for _ in steps(frames, not options.quiet):
        world.step()
    if options.picture:
        world.show().save(options.picture)
    print(json.dumps({"scene": world.name, "device": world.device_info.kind, "frames": frames,
                      "time": world.time, "particles": world.particle_count,
                      "state_hash": f"{world.state_hash():016x}"}))


def parser() -> argparse.ArgumentParser:
    program = argparse.ArgumentParser(prog="python -m meniscus", description=__doc__)
    program.add_argument("--version", action="version", version=f"meniscus {__version__}")
    commands = program.add_subparsers(dest="command", required=True)
    runs = commands.add_parser("run", help="run a scene and print its state as one line of JSON")
    runs.add_argument("scene", help="a scene file, or the name of a sample")
    runs.add_argument("--frames", type=int, help="in place of the scene's own number")
    runs.add_argument("--device", choices=("auto", "cpu", "cuda"), help="where to run")
    runs.add_argument("--threads", type=int, help="of the CPU device; 0 is one a core")
    runs.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="change a value of the scene")
    runs.add_argument("--picture", metavar="FILE.png", help="draw the last frame")
    runs.add_argument("--quiet", action="store_true", help="show no progress")
    commands.add_parser("samples", help="list the samples")
    commands.add_parser("devices", help="list the devices")
    return program


def main() -> int:
    options = parser().parse_args()
    try:
        if options.command == "run":
            run(options)
        elif options.command == "samples":
            print("\n".join(sample_names()))
        else:
            for device in list_devices():
                print(f"{device.kind}: {device.name}" + ("" if device.usable else f" ({device.reason})"))
    except Error as error:
        print(f"meniscus: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
