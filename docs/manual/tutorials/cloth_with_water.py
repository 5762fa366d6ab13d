# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: cloth that carries water. A sheet that hangs by its corners catches water, and the corners bear the weight
of both."""

import meniscus as m
import numpy as np

SPACING = 0.03  # m
G = 9.81  # m/s²

# Water on cloth needs short substeps: eight of 1/480 s.
world = m.World(particle_spacing=SPACING, substeps=8, iterations=8)
world.add_shape(name="floor", geometry=m.PlaneGeometry())
sheet = world.add_cloth(
    name="sheet", geometry=m.SheetGeometry(width=0.8, depth=0.8, columns=27, rows=27), pose=(0, 0.6, 0),
    stretch=(0.7, 1, 0.7),  # wider than the square of its corners, so that it sags
    fabric=m.FabricDef(density=0.3, warp_stiffness=40000, weft_stiffness=40000))
# Vertex (column, row) has the number row · columns + column.
corners = [world.add_attachment(name=name, cloth=sheet, vertices=[number])
           for name, number in (("west", 0), ("north", 26), ("south", 26 * 27), ("east", 26 * 27 + 26))]
view = {"width": 480, "height": 270, "position": (1.0, 1.0, 1.4), "target": (0, 0.4, 0)}

while world.time < 1:  # the sheet falls, and hangs
    world.step(1 / 60)
low = float(sheet.positions[:, 1].min())
water = world.add_fluid(name="water", xsph=20)
count = world.add_volume(fluid=water, region=m.BallRegion(radius=0.12), pose=(0, low + 0.13, 0))
world.show(**view).save("cloth_with_water_falls.png")
forces = []
while world.time < 3.5:
    world.step(1 / 60)
    if world.time > 2.5:
        forces.append(sum(np.array(corner.force) for corner in corners))
world.show(**view).save("cloth_with_water_rests.png")

pull = -float(np.mean(forces, axis=0)[1])  # N, of the cloth on the corners, downwards
lost = int((world.positions[:, 1] < SPACING).sum())  # splashed over the rim
weight = ((count - lost) * water.particle_mass + sheet.state.mass) * G
print(f"{count} particles, of which {lost} lie on the floor")
print(f"pull on the corners {pull:.1f} N, weight of water and cloth {weight:.1f} N")
print(f"edges are {sheet.state.mean_stretch:.1%} off their length at rest on average")

assert lost <= count // 50, "the cloth does not hold the water"
assert abs(pull / weight - 1) < 0.03, "the corners do not bear the weight"
