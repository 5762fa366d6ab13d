# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Imports a run of Meniscus into Blender and renders frames of it with motion blur, without a screen.

    meniscus run bunny_drop --export ply --surface --out RUN
    blender --background --python samples/blender/render_run.py -- RUN PICTURES --first 40 --count 10

The module bpy of PyPI does as well: python samples/blender/render_run.py RUN PICTURES. Without PICTURES and without
--background, Blender's window shows the run, and its timeline plays it. Each sequence of the run (surface, cloth, bodies) is one object, whose mesh follows the frame. It has the attribute
`velocity`, from which Cycles blurs. The surface takes it from its file, or else from the nearest particle.
"""
import argparse
import math
import sys
from pathlib import Path

import bpy
import mathutils
import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import ply  # noqa: E402

COLORS = {"surface": (0.25, 0.55, 0.85), "cloth": (0.7, 0.2, 0.15), "bodies": (0.7, 0.6, 0.45)}
PLACE, VELOCITY = ("x", "y", "z"), ("vx", "vy", "vz")


def velocities_of(vertices, places, particles):
    own = ply.vectors(vertices, VELOCITY)
    if own is not None:
        return own
    if particles is None or not len(places):
        return numpy.zeros_like(places)
    rows = ply.read_ply(particles)["vertex"]
    tree = mathutils.kdtree.KDTree(len(rows))
    for n, centre in enumerate(ply.vectors(rows, PLACE)):
        tree.insert(centre, n)
    tree.balance()
    return ply.vectors(rows, VELOCITY)[[tree.find(place)[1] for place in places]]


class Sequence:
    """The files of one name as one object."""

    def __init__(self, name, files, particles, material):
        self.files, self.particles = files, particles
        self.mesh = bpy.data.meshes.new(name)
        self.mesh.materials.append(material)
        self.object = bpy.data.objects.new(name, self.mesh)
        bpy.context.scene.collection.objects.link(self.object)

    def show(self, frame):
        """Puts the mesh of the last file up to a frame into the object."""
        numbers = [n for n in self.files if n <= frame]
        if not numbers:
            return
        read = ply.read_ply(self.files[numbers[-1]])
        self.mesh.clear_geometry()
        if not len(read["face"]):
            return
        places = ply.vectors(read["vertex"], PLACE)
        faces = read["face"]["vertex_indices"]
        moving = velocities_of(read["vertex"], places, self.particles.get(numbers[-1]))
        self.mesh.from_pydata(ply.z_up(places).tolist(), [], faces.tolist())
        self.mesh.polygons.foreach_set("use_smooth", numpy.ones(len(faces), dtype=bool))
        attribute = self.mesh.attributes.new("velocity", "FLOAT_VECTOR", "POINT")
        attribute.data.foreach_set("vector", ply.z_up(moving).ravel())
        self.mesh.update()


def material_of(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*COLORS[name], 1)
    if name == "surface":
        shader.inputs["Roughness"].default_value = 0.05
        shader.inputs["IOR"].default_value = 1.33
        shader.inputs["Transmission Weight"].default_value = 0.85
    return material


def import_run(run):
    """One object a sequence. The frame of Blender is that of the run, from 0 on."""
    folder = Path(run) / "frames"
    particles = ply.numbered(folder, "frame")
    sequences = [Sequence(name, files, particles, material_of(name))
                 for name in COLORS if (files := ply.numbered(folder, name))]
    if not sequences:
        sys.exit(f"{folder} has no surface_00000.ply, cloth_00000.ply or bodies_00000.ply")

    def follow(scene, *_):
        for sequence in sequences:
            sequence.show(scene.frame_current)

    bpy.app.handlers.frame_change_pre.append(follow)
    return sequences


def bounds(sequences):
    corners = [sequence.object.matrix_world @ mathutils.Vector(corner)
               for sequence in sequences for corner in sequence.object.bound_box if sequence.mesh.vertices]
    return [[f(c[k] for c in corners) for k in range(3)] for f in (min, max)]


def set_stage(lower, upper):
    """A floor under the run, the sun, the sky, and a camera that sees all of it."""
    scene = bpy.context.scene
    centre = mathutils.Vector([(a + b) / 2 for a, b in zip(lower, upper)])
    size = math.dist(lower, upper)
    bpy.ops.mesh.primitive_plane_add(size=20 * size, location=(centre.x, centre.y, lower[2] - 0.002 * size))
    floor = bpy.data.materials.new("floor")
    floor.use_nodes = True
    floor.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.55, 0.55, 0.52, 1)
    bpy.context.object.data.materials.append(floor)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 4, 0.05
    sun.rotation_euler = (math.radians(35), math.radians(20), 0)
    scene.collection.objects.link(sun)
    scene.world = scene.world or bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.75, 0.85, 1, 1)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = centre + 1.6 * size * mathutils.Vector((0.45, -0.8, 0.42))
    camera.rotation_euler = (centre - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera


def set_render(width, height, samples, frame_time):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = samples < 256
    scene.cycles.device = "CPU"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    # Velocities are in m/s: a frame must last as long as in the run.
    scene.render.fps = 1000
    scene.render.fps_base = 1000 * frame_time
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter = 0.5
    scene.render.image_settings.file_format = "PNG"


def arguments():
    given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else sys.argv[1:]
    parser = argparse.ArgumentParser(prog="render_run.py", description=__doc__.splitlines()[0])
    parser.add_argument("run", help="folder of a run with --export ply")
    parser.add_argument("pictures", nargs="?", help="folder for frame_00000.png and so on; none: import alone")
    parser.add_argument("--first", type=int, default=0, help="first frame")
    parser.add_argument("--count", type=int, default=10, help="number of frames")
    parser.add_argument("--frame-time", type=float, default=0.016, help="s, frame_time of the scene")
    parser.add_argument("--size", default="640x360", help="width and height in pixels")
    parser.add_argument("--samples", type=int, default=32, help="paths a pixel")
    return parser.parse_args(given)


def main():
    options = arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    sequences = import_run(options.run)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = options.first, options.first + options.count - 1
    scene.frame_set(options.first)
    set_stage(*bounds(sequences))
    width, height = map(int, options.size.split("x"))
    set_render(width, height, options.samples, options.frame_time)
    for frame in range(scene.frame_start, scene.frame_end + 1 if options.pictures else 0):
        scene.frame_set(frame)
        scene.render.filepath = str(Path(options.pictures).resolve() / f"frame_{frame:05d}.png")
        bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    main()
