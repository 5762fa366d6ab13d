# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: a crate that floats, against Archimedes. Crates of three densities come to rest in water."""

import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SPACING = 0.05  # m
TANK, DEPTH = 0.9, 0.4  # m, width of the tank and depth of the water
HALF = np.array((0.25, 0.15, 0.25))  # m, half of the edges of the crate
DENSITIES = (300, 500, 700)  # kg/m³
HEIGHT, FOOTPRINT = 2 * HALF[1], 4 * HALF[0] * HALF[2]  # m, m²


def draft_of(density: float, path: list[tuple[float, float]]) -> float:
    """How deep a crate of this density sinks in, m. Its height over the water goes to `path`."""
    world = m.World(particle_spacing=SPACING)
    world.add_shape(name="tank", geometry=m.ContainerGeometry(
        half_extents=(TANK / 2, 0.5, TANK / 2), openings=[m.Opening(face="y_high")]), pose=(0, 0.5, 0))
    water = world.add_fluid(name="water", rest_density=1000, xsph=50)
    # The crate starts with its lower face in the water. add_volume leaves out what would be inside of it.
    crate = world.add_body(name="crate", geometry=m.BoxGeometry(half_extents=HALF), density=density,
                           pose=(0, DEPTH + 0.05, 0))
    count = world.add_volume(fluid=water, region=m.BoxRegion(
        lower=(-TANK / 2, 0, -TANK / 2), upper=(TANK / 2, DEPTH, TANK / 2)))
    drafts = []
    while world.time < 2.5:
        world.step(1 / 60)
        # The level follows from volumes: that of the water, and of the part of the crate below the level.
        bottom = crate.position[1] - HALF[1]
        level = (count * SPACING**3 - bottom * FOOTPRINT) / (TANK**2 - FOOTPRINT)
        path.append((world.time, level - bottom))
        if world.time > 2:
            drafts.append(level - bottom)
    if density == 500:
        world.show(width=480, height=270, position=(1, 1.3, 1.8), target=(0, 0.3, 0)).save("floating_crate_rests.png")
    return float(np.mean(drafts))


worst = 0.0
plt.figure(figsize=(6.4, 3.6), layout="constrained")
for density in DENSITIES:
    path: list[tuple[float, float]] = []
    draft, expected = draft_of(density, path), density / 1000 * HEIGHT
    worst = max(worst, abs(draft - expected) / HEIGHT)
    print(f"{density} kg/m³: draft {draft:.4f} m, Archimedes {expected:.4f} m")
    line, = plt.plot(*zip(*path), label=f"{density} kg/m³")
    plt.axhline(expected, color=line.get_color(), linestyle=":")
plt.xlabel("time (s)"), plt.ylabel("draft (m)"), plt.legend()
plt.savefig("floating_crate.png", dpi=100)

print(f"largest error {worst:.1%} of the height")
assert worst < 0.05, "the crates do not float as Archimedes says"
