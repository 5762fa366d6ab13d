# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: your own force. A spring pulls each particle of a drop to the origin. Pressure inside the drop cannot move
its centre of mass, which must therefore swing as a harmonic oscillator."""

import math

import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FRAME = 1 / 120  # s
OMEGA = 2 * math.pi  # 1/s: one swing a second
START = 0.5  # m

world = m.World(particle_spacing=0.05, gravity=(0, 0, 0), substeps=2)
water = world.add_fluid(name="water")
world.add_volume(fluid=water, region=m.BallRegion(radius=0.25), pose=(START, 0, 0))


def apply_spring(world: m.World, fluid: m.Fluid, dt: float) -> None:
    """The impulse of the force −m ω² x on each particle for a frame of dt seconds."""
    world.apply_impulses(world.ids, -fluid.particle_mass * OMEGA**2 * dt * world.positions)


world.show(width=480, height=270, position=(0, 0.6, 2.4)).save("own_force_start.png")
times, centres = [], []
apply_spring(world, water, FRAME / 2)  # half a push first: positions and velocities then leapfrog
while world.time < 2 - FRAME / 2:
    world.step(FRAME)
    apply_spring(world, water, FRAME)
    times.append(world.time)
    centres.append(world.positions[:, 0].astype(np.float64).mean())
world.show(width=480, height=270, position=(0, 0.6, 2.4)).save("own_force_end.png")

expected = START * np.cos(OMEGA * np.array(times))
error = np.abs(np.array(centres) - expected).max() / START
plt.figure(figsize=(6.4, 3.6), layout="constrained")
plt.plot(times, centres, label="drop"), plt.plot(times, expected, ":", label="x₀ cos ωt")
plt.xlabel("time (s)"), plt.ylabel("centre of mass (m)"), plt.legend()
plt.savefig("own_force.png", dpi=100)
print(f"{world.particle_count} particles; the centre is at most {error:.2%} of its amplitude off")
assert error < 0.01, "the centre of mass does not swing as it must"
