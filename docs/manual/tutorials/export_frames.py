# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: to Blender and Houdini. Exports the frames of a scene, and reads them as any other program would. The
volume inside the surface must be that of the particles, and the sheet must have its triangles in each frame."""

import os
import pathlib
import subprocess

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FRAMES = 12
program = os.environ.get("MENISCUS_PROGRAM", "meniscus")
scene = pathlib.Path(__file__).with_name("tank.json")
folder = pathlib.Path("out/export")

subprocess.run([program, "run", str(scene), "--frames", str(FRAMES), "--out", str(folder), "--quiet",
                "--export", "obj,ply,usd", "--surface"], check=True)


def read_obj(path: pathlib.Path) -> tuple[np.ndarray, np.ndarray]:
    """The vertices and triangles of an OBJ file."""
    vertices, triangles = [], []
    for line in path.read_text().splitlines():
        kind, *values = line.split() or [""]
        if kind == "v":
            vertices.append([float(value) for value in values[:3]])
        elif kind == "f":
            triangles.append([int(value.split("/")[0]) - 1 for value in values])
    return np.array(vertices), np.array(triangles)


def volume_inside(vertices: np.ndarray, triangles: np.ndarray) -> float:
    """m³, by the divergence theorem."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def count_of(ply: pathlib.Path) -> int:
    """The number of vertices in a PLY file: its header is text, whatever follows."""
    head = ply.read_bytes().split(b"end_header")[0].decode()
    return next(int(line.split()[2]) for line in head.splitlines() if line.startswith("element vertex"))


frames = folder / "frames"
volumes = []
for number in range(FRAMES + 1):  # frame 0 is the state before the first step
    surface = read_obj(frames / f"surface_{number:05}.obj")
    volumes.append(volume_inside(*surface))
expected = count_of(frames / "frame_00000.ply") * 0.05**3
print(f"{len(list(frames.iterdir()))} files; volume {volumes[-1]:.4f} m³, of the particles {expected:.4f} m³")

vertices, triangles = read_obj(frames / f"surface_{FRAMES:05}.obj")
axes = plt.figure(figsize=(6.4, 3.6), layout="constrained").add_subplot(projection="3d")
# Meniscus has y up. Here, as in Blender, z is up.
axes.plot_trisurf(vertices[:, 0], -vertices[:, 2], vertices[:, 1], triangles=triangles, color="tab:blue")
axes.set_aspect("equal")
plt.savefig("export_frames.png", dpi=75)

stage = (folder / "scene.usda").read_text()
assert f"endTimeCode = {FRAMES}\n" in stage and 'def Mesh "water"' in stage, "the stage lacks the surface"
assert np.abs(np.array(volumes) / expected - 1).max() < 0.05, "the surface does not hold the volume of the particles"
