# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: water in a tank. A block of water collapses, and finds the depth that its volume asks for."""

import meniscus as m

SPACING = 0.04  # m
WIDTH, DEPTH = 1.2, 0.4  # m, of the tank

# A world has one particle spacing. "auto" takes a GPU where there is one.
world = m.World(particle_spacing=SPACING, device="auto")
world.add_shape(name="tank", geometry=m.ContainerGeometry(
    half_extents=(WIDTH / 2, 0.4, DEPTH / 2), openings=[m.Opening(face="y_high")]), pose=(0, 0.4, 0))
water = world.add_fluid(name="water", rest_density=1000, xsph=20)
count = world.add_volume(fluid=water, region=m.BoxRegion(
    lower=(-WIDTH / 2, 0, -DEPTH / 2), upper=(0, 0.6, DEPTH / 2)))
print(f"{count} particles on {world.device_info.name}")
for warning in world.warnings():
    print("warning:", warning)

for second, name in ((0.0, "start"), (0.3, "collapse"), (4.0, "later")):
    while world.time < second - 1e-6:
        world.step(1 / 60)
    world.show(width=480, height=270, position=(0.8, 0.9, 2.6), target=(0, 0.25, 0)).save(f"water_tank_{name}.png")

volume = count * SPACING**3
expected = volume / (WIDTH * DEPTH)
depth = 2 * world.positions[:, 1].mean()  # of level water
measured = world.diagnostics()
print(f"depth {depth:.3f} m, expected {expected:.3f} m")
print(f"mean density error {measured.density_error_mean:.2%}, outside the tank {measured.outside}")

assert world.particle_count == count and measured.outside == 0, "water was lost"
assert measured.density_error_mean < 0.005, "the water is compressed"
assert abs(depth / expected - 1) < 0.04, "the depth does not fit the volume"
