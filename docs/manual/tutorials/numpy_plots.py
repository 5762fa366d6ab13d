# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: NumPy and plots. The pressure in a column of water, particle by particle, against ρ g d."""

import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SPACING, WIDTH, HEIGHT = 0.05, 0.4, 0.8  # m

world = m.World(particle_spacing=SPACING)
world.add_shape(name="column", geometry=m.ContainerGeometry(
    half_extents=(WIDTH / 2, 0.6, WIDTH / 2), openings=[m.Opening(face="y_high")]), pose=(0, 0.6, 0))
water = world.add_fluid(name="water", rest_density=1000, xsph=100)
# Disordered, as in water that has been stirred: a lattice would carry pressure in steps of whole layers.
world.add_volume(fluid=water, seeding="disordered", region=m.BoxRegion(
    lower=(-WIDTH / 2, 0, -WIDTH / 2), upper=(WIDTH / 2, HEIGHT, WIDTH / 2)))

speeds, sums = [], np.zeros(world.particle_count)
frames, averaged = 240, 60
for frame in range(frames):
    world.step(1 / 60)
    speeds.append(np.sqrt((world.velocities.astype(np.float64) ** 2).sum(axis=1).mean()))
    if frame >= frames - averaged:
        sums += world.pressures  # the order of particles is that of their ids, and stays
pressures = sums / averaged

# Read-outs are views without a copy. One that is held keeps its values when the world goes on.
height = world.positions[:, 1]
depth = 2 * height.mean() - height
deep = depth > 2 * world.support_radius  # beside the surface the pressure is less exact
layer = (depth[deep] / (2 * SPACING)).astype(int)  # a mean for each layer of two spacings
filled = np.bincount(layer) > 0
means = [np.bincount(layer, weights=values)[filled] / np.bincount(layer)[filled]
         for values in (depth[deep], pressures[deep])]
error = np.abs(means[1] / (9810 * means[0]) - 1).max()
np.savetxt("pressures.csv", np.column_stack((depth, pressures)), delimiter=",", header="depth (m),pressure (Pa)")

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
left.plot(depth, pressures, ".", markersize=2)
left.plot(*means, "o", label="means of layers")
left.plot([0, HEIGHT], [0, 9810 * HEIGHT], "k:", label="ρ g d")
left.set_xlabel("depth (m)"), left.set_ylabel("pressure (Pa)"), left.legend()
right.semilogy(np.arange(1, frames + 1) / 60, speeds)
right.set_xlabel("time (s)"), right.set_ylabel("RMS speed (m/s)")
figure.savefig("numpy_plots.png", dpi=100)

print(f"{len(height)} particles; the mean pressure of each deep layer is within {error:.1%} of ρ g d")
assert error < 0.08, "the pressure does not rise by ρ g"
