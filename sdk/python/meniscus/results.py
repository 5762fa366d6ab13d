# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""What queries return. Arrays are read-only, and belong to the moment of the call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._core import Body, Cloth, DeviceArray, Shape

Vector = tuple[float, float, float]


class ParticleContacts(NamedTuple):
    """Contacts of particles in the last substep, one element a contact.

    bodies, shapes and cloths hold a place in the list of the same name of World, or -1."""

    particles: NDArray[np.uint64]  # ids
    bodies: NDArray[np.int64]  # places in World.bodies, or -1
    shapes: NDArray[np.int64]  # places in World.shapes, or -1
    cloths: NDArray[np.int64]  # places in World.cloths, or -1
    points: NDArray[np.float32]  # m
    normals: NDArray[np.float32]  # unit, out of the solid
    impulses: NDArray[np.float32]  # N·s, on the particle


class SolidContact(NamedTuple):
    """Two solids that touch or are about to. The second is a body or a shape."""

    a: Body  # the first
    b: Body | None  # the second, if it is a body
    shape: Shape | None  # the second, if it is a fixed shape
    point: Vector  # m, on b
    normal: Vector  # unit, from b to a
    distance: float  # m, negative if they overlap
    impulse: float  # N·s along the normal


class ContactEvent(NamedTuple):
    """Two solids that began or ceased to touch in the last step."""

    a: Body | None  # the first
    b: Body | None  # the second, if it is a body
    shape: Shape | None  # the second, if it is a fixed shape
    began: bool  # else they ceased to touch


class TearEvent(NamedTuple):
    """A vertex that tore in two in the last step."""

    cloth: Cloth  # the piece that tore
    copy: int  # the number of the new vertex
    original: int  # the number of the vertex that tore


class RayHit(NamedTuple):
    """The first hit of a ray: a body, a shape or a particle."""

    body: Body | None  # if it is a body
    shape: Shape | None  # if it is a fixed shape
    particle: int | None  # its id, if it is a particle
    point: Vector  # m
    normal: Vector  # unit, against the ray
    distance: float  # m along the ray


class Overlaps(NamedTuple):
    """What overlaps a region."""

    bodies: list[Body]  # that overlap it
    shapes: list[Shape]  # fixed shapes that overlap it
    particles: NDArray[np.uint64]  # ids of those with their centres inside


class Ellipsoids(NamedTuple):
    """One a particle."""

    centres: NDArray[np.float32]  # m
    radii: NDArray[np.float32]  # m
    rotations: NDArray[np.float32]  # quaternions (x, y, z, w)


class Diffuse(NamedTuple):
    """Spray, foam and bubbles."""

    positions: NDArray[np.float32]  # m
    velocities: NDArray[np.float32]  # m/s
    life: NDArray[np.float32]  # s, remaining
    kinds: NDArray[np.uint32]  # 0 is spray, 1 foam, 2 a bubble


class SurfaceMesh(NamedTuple):
    """The surface of a fluid, closed."""

    vertices: NDArray[np.float32]  # m
    normals: NDArray[np.float32]  # unit, out of the fluid
    triangles: NDArray[np.uint32]  # counter-clockwise as seen from outside
    velocities: NDArray[np.float32]  # m/s, one a vertex


class DeviceArrays(NamedTuple):
    """The particles in the memory of the world's device, in the order of World.ids."""

    ids: DeviceArray  # uint64
    positions: DeviceArray  # float32, m
    velocities: DeviceArray  # float32, m/s
    phases: DeviceArray  # uint32: Fluid.index
