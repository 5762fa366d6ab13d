# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""What queries return. Arrays are read-only, and belong to the moment of the call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._core import Body, Cloth, DeviceArray, Rope, Shape, StepReport

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


class SleepEvent(NamedTuple):
    """A body that fell asleep or woke since the end of the step before. A call that wakes a body counts."""

    body: Body  # which
    awake: bool  # whether it woke; else it fell asleep


class FlowEvents(NamedTuple):
    """Particles that emitters made and sinks removed in the last step, one element a particle."""

    emitters: NDArray[np.int64]  # places in World.emitters, or -1; of imposed ones, once it has passed the opening
    sinks: NDArray[np.int64]  # places in World.sinks, or -1
    particles: NDArray[np.uint64]  # ids, which are gone where a sink removed them


class RayHit(NamedTuple):
    """The first hit of a ray: a body, a shape, a particle, cloth or a rope."""

    body: Body | None  # if it is a body
    shape: Shape | None  # if it is a fixed shape
    particle: int | None  # its id, if it is a particle
    point: Vector  # m
    normal: Vector  # unit, against the ray
    distance: float  # m along the ray
    cloth: Cloth | None  # if it is cloth
    rope: Rope | None  # if it is a rope or rod
    element: int | None  # of cloth the triangle, of a rope the segment; by number


class NearestPoint(NamedTuple):
    """The nearest place on a surface: of a body, a shape, a particle, cloth or a rope."""

    body: Body | None  # if it is a body
    shape: Shape | None  # if it is a fixed shape
    particle: int | None  # its id, if it is a particle
    point: Vector  # m, on the surface
    normal: Vector  # unit, out of the surface; of cloth towards the given point
    distance: float  # m, from the given point; negative inside
    cloth: Cloth | None  # if it is cloth
    rope: Rope | None  # if it is a rope or rod
    element: int | None  # of cloth the triangle, of a rope the segment; by number


class Overlaps(NamedTuple):
    """What overlaps a region."""

    bodies: list[Body]  # that overlap it
    shapes: list[Shape]  # fixed shapes that overlap it
    particles: NDArray[np.uint64]  # ids of those with their centres inside
    cloths: list[Cloth]  # pieces of which a triangle overlaps it
    ropes: list[Rope]  # of which a segment overlaps it, with its radius


class FluidSamples(NamedTuple):
    """The fluid at points, as weighted means over the particles within a support radius; one element a point."""

    densities: NDArray[np.float32]  # kg/m³; less beside walls and the surface; 0 without particles
    velocities: NDArray[np.float32]  # m/s; 0 without particles
    particles: NDArray[np.uint32]  # within the support radius


class ReplayStep(NamedTuple):
    """A step that a replay has made again."""

    report: StepReport  # of the step that was made now
    time: float  # s, of the world after it
    hash: int  # World.state_hash after it
    recorded_hash: int  # the same in the run that was recorded


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


class BatchArrays(NamedTuple):
    """The particles of a WorldBatch in the memory of its device, worlds × particles × 3, and its cloth, worlds ×
    vertices × 3."""

    positions: DeviceArray  # float32, m, local to each world
    velocities: DeviceArray  # float32, m/s
    cloth_positions: DeviceArray | None  # float32, m; None without cloth
    cloth_velocities: DeviceArray | None  # float32, m/s


class BatchContacts(NamedTuple):
    """Contacts of the solids of one world of a WorldBatch, one element a contact. The second is a body or a shape."""

    a: NDArray[np.int64]  # places in World.bodies of the archetype
    b: NDArray[np.int64]  # likewise, or -1
    shapes: NDArray[np.int64]  # places in World.shapes, or -1
    points: NDArray[np.float32]  # m, on the second
    normals: NDArray[np.float32]  # unit, from the second to the first
    distances: NDArray[np.float32]  # m, negative where they overlap
    impulses: NDArray[np.float32]  # N·s along the normals, in the last step of Bullet


class BatchContactEvent(NamedTuple):
    """Two solids of one world of a WorldBatch that began or ceased to touch in its last step."""

    a: int  # place in World.bodies of the archetype
    b: int  # likewise, or -1
    shape: int  # place in World.shapes, or -1
    began: bool  # else they ceased to touch


class BatchSleepEvent(NamedTuple):
    """A body of one world of a WorldBatch that fell asleep or woke in its last step."""

    body: int  # place in World.bodies of the archetype
    awake: bool  # whether it woke; else it fell asleep


class BatchBodies(NamedTuple):
    """The bodies of a WorldBatch, worlds × bodies × 3 or 4, in the order of their creation."""

    positions: NDArray[np.float32]  # m, of the geometries' frames
    rotations: NDArray[np.float32]  # unit quaternions (x, y, z, w)
    velocities: NDArray[np.float32]  # m/s, of the centres of mass
    angular_velocities: NDArray[np.float32]  # rad/s
    fluid_forces: NDArray[np.float32]  # N, of all particles on the bodies, mean over the last step
    fluid_torques: NDArray[np.float32]  # N·m, about the centres of mass, likewise
