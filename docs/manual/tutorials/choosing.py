# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: choosing spacing, substeps and iterations. The same collapse with several choices: what each costs, and
how much it compresses the water and stretches cloth."""

import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def collapse(spacing: float, substeps: int, iterations: int) -> tuple[int, float, float]:
    """Number of particles, mean density error over a second, and the time that a frame takes, ms."""
    world = m.World(particle_spacing=spacing, substeps=substeps, iterations=iterations)
    world.add_shape(geometry=m.ContainerGeometry(half_extents=(0.6, 0.6, 0.15)))
    water = world.add_fluid()
    count = world.add_volume(fluid=water, region=m.BoxRegion(lower=(-0.6, -0.6, -0.15), upper=(0, 0.3, 0.15)))
    errors, times = [], []
    for _ in range(45):
        times.append(world.step(1 / 60).ms)
        errors.append(world.diagnostics().density_error_mean)
    return count, float(np.mean(errors)), float(np.median(times))


def catch(substeps: int, iterations: int) -> tuple[float, float]:
    """Mean stretch of a sheet that holds a ball of ten times its weight, and the time that a frame takes, ms."""
    world = m.World(substeps=substeps, iterations=iterations)
    sheet = world.add_cloth(geometry=m.SheetGeometry(columns=21, rows=21), fabric={"density": 0.3})
    world.add_attachment(cloth=sheet, vertices=[0, 20, 420, 440])
    world.add_body(geometry=m.SphereGeometry(radius=0.15), pose=(0, 0.16, 0), mass=3)
    times, stretches = [], []
    for frame in range(90):
        times.append(world.step(1 / 60).ms)
        stretches.append(sheet.state.mean_stretch)
    return float(np.mean(stretches[60:])), float(np.median(times))


print("water, spacing 0.05 m:")
water = {choice: collapse(0.05, *choice) for choice in ((1, 4), (1, 16), (4, 4), (4, 10), (8, 4))}
for (substeps, iterations), (_, error, ms) in water.items():
    print(f"  {substeps} × {iterations:2}: mean density error {error:.3%}, {ms:.1f} ms a frame")
print("water, 4 × 10:")
for spacing in (0.1, 0.05):
    count, error, ms = collapse(spacing, 4, 10)
    print(f"  spacing {spacing} m: {count} particles, {error:.3%}, {ms:.1f} ms a frame")
print("cloth:")
cloth = {choice: catch(*choice) for choice in ((1, 16), (2, 8), (4, 4), (8, 2), (16, 1))}
for (substeps, iterations), (stretch, ms) in cloth.items():
    print(f"  {substeps:2} × {iterations:2}: mean stretch {stretch:.3%}, {ms:.1f} ms a frame")

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
left.bar([f"{a} × {b}" for a, b in water], [100 * error for _, error, _ in water.values()])
left.set_ylabel("water: mean density error (%)")
right.bar([f"{a} × {b}" for a, b in cloth], [100 * stretch for stretch, _ in cloth.values()])
right.set_ylabel("cloth: mean stretch (%)")
figure.supxlabel("substeps × iterations"), figure.savefig("choosing.png", dpi=100)

assert water[4, 10][1] < water[4, 4][1], "more iterations must compress the water less"
assert water[8, 4][1] < water[1, 4][1], "more substeps must compress the water less"
assert cloth[16, 1][0] < cloth[1, 16][0], "substeps must help cloth more than iterations"
