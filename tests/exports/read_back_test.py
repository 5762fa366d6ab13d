#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# read_back_test.py PROGRAM: exports a scene in all formats and reads each file back, with readers of our own and with
# programs of others: usd-core, pyvista, trimesh, meshio and alembic3d. Counts and values must be equal to 1e-6. A program of others
# that is not installed is skipped with a reason; tests/exports/install_readers installs all of them.

import importlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from files import UsdText, read_obj, read_ply, read_vtp, vectors

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else os.environ["MENISCUS_PROGRAM"]
FRAMES = 3
FLUIDS = ["water", "olive_oil", "sand"]
CLOTHS = ["sheet", "flag", "rag"]
POSITION, NORMAL, VELOCITY = ("x", "y", "z"), ("nx", "ny", "nz"), ("vx", "vy", "vz")


def run_of(out, *options):
    return [PROGRAM, "run", HERE / "scene.json", "--out", out, "--quiet", "--size", "64x36", "--surface", *options]


def reader(test, module):
    """A module of others, or the test is skipped."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        test.skipTest(f"{missing}; tests/exports/install_readers installs it")


def flat(values):
    for value in values:
        if hasattr(value, "__len__"):  # vectors of USD have no more
            yield from flat(value)
        else:
            yield value


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.holder.name) / "out"
        subprocess.run(run_of(cls.out, "--frames", str(FRAMES), "--export", "ply,vtp,obj,usd"), check=True)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def ply(self, kind, frame):
        return read_ply(self.out / "frames" / f"{kind}_{frame:05}.ply")

    def path(self, kind, frame, ending):
        return self.out / "frames" / f"{kind}_{frame:05}.{ending}"

    def assert_same(self, found, wanted, what):
        found, wanted = list(flat(found)), list(flat(wanted))
        self.assertEqual(len(found), len(wanted), what)
        for a, b in zip(found, wanted):
            self.assertLessEqual(abs(float(a) - float(b)), 1e-6 * max(1, abs(float(b))), what)


    def test_the_scene_moves_and_has_all(self):
        for kind in ("frame", "diffuse", "bodies", "cloth", "ropes", "surface"):
            self.assertTrue(self.path(kind, 0, "ply").exists(), kind)
        last = self.ply("surface", FRAMES)["vertex"]
        self.assertGreater(max(map(abs, last["vx"])), 1)
        self.assertGreater(len(self.ply("cloth", FRAMES)["vertex"]["x"]), len(self.ply("cloth", 0)["vertex"]["x"]))
        self.assertGreater(len(self.ply("frame", 0)["vertex"]["x"]), 300)

    # ---- VTP against PLY ----

    def compare_vtp(self, found, wanted, names):
        vertex = wanted["vertex"]
        for array, properties in names.items():
            self.assert_same(found[array], vectors(vertex, *properties), array)

    def test_vtp(self):
        for frame in range(FRAMES + 1):
            smooth = {"Points": POSITION, "velocity": VELOCITY, "Normals": NORMAL}
            for kind, names in {"frame": {"Points": POSITION, "velocity": VELOCITY, "id": ("id",)},
                                "bodies": {"Points": POSITION, "velocity": VELOCITY},
                                "ropes": {"Points": POSITION, "velocity": VELOCITY, "radius": ("radius",)},
                                "cloth": smooth, "surface": smooth}.items():
                found, wanted = read_vtp(self.path(kind, frame, "vtp")), self.ply(kind, frame)
                self.compare_vtp(found, wanted, names)
                if "face" in wanted:
                    self.assert_same(found["connectivity"], wanted["face"]["vertex_indices"], kind)
            self.assert_same(read_vtp(self.path("cloth", frame, "vtp"))["texture"],
                             self.ply("cloth", frame)["face"]["texcoord"], "texture")

    def test_vtp_by_pyvista(self):
        pyvista = reader(self, "pyvista")
        for frame in range(FRAMES + 1):
            for kind in ("frame", "bodies", "cloth", "surface", "ropes"):
                found, wanted = pyvista.read(self.path(kind, frame, "vtp")), self.ply(kind, frame)
                self.assert_same(found.points, vectors(wanted["vertex"], *POSITION), kind)
                self.assert_same(found.point_data["velocity"], vectors(wanted["vertex"], *VELOCITY), kind)
                if "face" in wanted:
                    self.assertEqual(found.n_cells, len(wanted["face"]["vertex_indices"]))
                    self.assert_same(found.regular_faces, wanted["face"]["vertex_indices"], kind)
                if kind == "cloth":
                    self.assert_same(found.cell_data["texture"], wanted["face"]["texcoord"], "texture")

    # ---- PLY and OBJ ----

    def test_ply_by_meshio(self):
        meshio = reader(self, "meshio")
        for frame in range(FRAMES + 1):
            # It reads no faces with more than their corners, so particles alone.
            found, wanted = meshio.read(self.path("frame", frame, "ply")), self.ply("frame", frame)
            self.assert_same(found.points, vectors(wanted["vertex"], *POSITION), "frame")
            for name in VELOCITY:
                self.assert_same(found.point_data[name], wanted["vertex"][name], name)

    def test_ply_by_trimesh(self):
        trimesh = reader(self, "trimesh")
        for frame in range(FRAMES + 1):
            for kind in ("bodies", "cloth", "surface"):
                found = trimesh.load(self.path(kind, frame, "ply"), process=False, fix_texture=False)
                wanted = self.ply(kind, frame)
                self.assert_same(found.vertices, vectors(wanted["vertex"], *POSITION), kind)
                self.assert_same(found.faces, wanted["face"]["vertex_indices"], kind)
                raw = found.metadata["_ply_raw"]["vertex"]["data"]
                for name in VELOCITY:
                    self.assert_same(raw[name], wanted["vertex"][name], name)

    def test_obj(self):
        for frame in range(FRAMES + 1):
            for kind in ("bodies", "cloth", "surface"):
                (vertices, faces), wanted = read_obj(self.path(kind, frame, "obj")), self.ply(kind, frame)
                self.assert_same(vertices, vectors(wanted["vertex"], *POSITION), kind)
                self.assert_same([[v for v, _ in f] for f in faces], wanted["face"]["vertex_indices"], kind)
                if kind == "cloth":
                    self.assert_same([[uv for _, uv in f] for f in faces], wanted["face"]["texcoord"], kind)

    def test_shapes_are_written_once(self):
        shapes = read_ply(self.out / "frames/shapes.ply")
        self.assertEqual(set(shapes["face"]["shape"]), {1, 2}, "a plane has no triangles")
        self.assert_same(read_vtp(self.out / "frames/shapes.vtp")["Points"], vectors(shapes["vertex"], *POSITION), "")

    # ---- textures ----

    def test_the_texture_of_a_file_keeps_its_seam(self):
        _, file_faces = read_obj(HERE / "flag.obj")
        wanted = sorted(tuple(sorted(flat(uv for _, uv in face))) for face in file_faces)
        face = self.ply("cloth", 0)["face"]
        found = [uv for uv, cloth in zip(face["texcoord"], face["cloth"]) if cloth == 1]
        found = sorted(tuple(sorted(uv)) for uv in found)
        self.assert_same(found, wanted, "flag")

    def test_the_texture_of_a_sheet_is_its_grid(self):
        for frame in range(FRAMES + 1):
            face = self.ply("cloth", frame)["face"]
            for corners, uv, cloth in zip(face["vertex_indices"], face["texcoord"], face["cloth"]):
                if cloth == 0:
                    grid = [(v % 9 / 8, v // 9 / 6) for v in corners]
                    self.assert_same(uv, grid, "sheet")

    # ---- USD against PLY ----

    def compare_usd(self, value, frame):
        """`value(attribute, frame)`: the value of an attribute of the stage."""
        self.compare_particles(value, frame)
        for kind, names in (("cloth", CLOTHS), ("surface", FLUIDS[:2])):
            self.compare_meshes(value, frame, kind, names)
        self.compare_ropes(value, frame)
        diffuse = self.ply("diffuse", frame)["vertex"]
        self.assert_same(value("/scene/diffuse.points", frame), vectors(diffuse, *POSITION), "diffuse")

    def compare_particles(self, value, frame):
        all_particles = self.ply("frame", frame)["vertex"]
        for number, name in enumerate(FLUIDS):
            wanted = {p: [x for x, f in zip(all_particles[p], all_particles["fluid"]) if f == number]
                      for p in all_particles}
            prim = f"/scene/particles/{name}"
            self.assert_same(value(prim + ".points", frame), vectors(wanted, *POSITION), prim)
            self.assert_same(value(prim + ".velocities", frame), vectors(wanted, *VELOCITY), prim)
            self.assert_same(value(prim + ".ids", frame), wanted["id"], prim)
            self.assert_same(value(prim + ".widths", frame), [0.1], prim)

    def compare_meshes(self, value, frame, kind, names):
        wanted = self.ply(kind, frame)
        vertices = {p: vectors(wanted["vertex"], *p) for p in (POSITION, VELOCITY, NORMAL)}
        part = wanted["face"]["cloth" if kind == "cloth" else "fluid"]
        first = 0
        for number, name in enumerate(names):
            prim = f"/scene/{kind}/{name}"
            rows = [i for i, p in enumerate(part) if p == number]
            faces = [wanted["face"]["vertex_indices"][i] for i in rows]
            end = max([first, *(v + 1 for f in faces for v in f)])
            self.assert_same(value(prim + ".points", frame), vertices[POSITION][first:end], prim)
            self.assert_same(value(prim + ".velocities", frame), vertices[VELOCITY][first:end], prim)
            self.assert_same(value(prim + ".normals", frame), vertices[NORMAL][first:end], prim)
            corners = [v - first for face in faces for v in face]
            self.assert_same(value(prim + ".faceVertexIndices", frame), corners, prim)
            self.assert_same(value(prim + ".faceVertexCounts", frame), [3] * len(faces), prim)
            if kind == "cloth":
                texture = [wanted["face"]["texcoord"][i] for i in rows]
                self.assert_same(value(prim + ".primvars:st", frame), texture, prim)
            first = end

    def compare_ropes(self, value, frame):
        ropes = self.ply("ropes", frame)["vertex"]
        points = list(flat(value("/scene/ropes/line.points", frame))) + list(flat(value("/scene/ropes/hoop.points", frame)))
        self.assert_same(points[:-3], vectors(ropes, *POSITION), "ropes")
        self.assert_same(points[-3:], points[7 * 3 : 8 * 3], "the hoop ends where it begins")

    def test_usd(self):
        stage = UsdText(self.out / "scene.usda")
        for key, wanted in {"metersPerUnit": "1", "upAxis": '"Y"', "startTimeCode": "0", "timeCodesPerSecond": "24",
                            "endTimeCode": str(FRAMES), "defaultPrim": '"scene"'}.items():
            self.assertEqual(stage.metadata[key], wanted, key)
        for frame in range(FRAMES + 1):
            self.compare_usd(stage.value, frame)
        self.assert_same(stage.value("/scene/materials/sheet/surface.inputs:diffuseColor"), (0.8, 0.2, 0.1), "")
        self.assertFalse(list((self.out / "frames").glob("*.usda")), "a short run is one file")

    def compare_bodies(self, usd, stage, frame):
        """The triangles of bodies by the transforms of the stage."""
        from pxr import Gf, UsdGeom

        cache, found = UsdGeom.XformCache(frame), []
        for name in ("crate__red", "crate__red_2"):
            mesh = stage.GetPrimAtPath(f"/scene/bodies/{name}/mesh")
            to_world = cache.GetLocalToWorldTransform(mesh)
            found += [to_world.Transform(Gf.Vec3d(p)) for p in mesh.GetAttribute("points").Get()]
        wanted = vectors(self.ply("bodies", frame)["vertex"], *POSITION)
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(flat(found), flat(wanted)):
            self.assertLessEqual(abs(a - b), 2e-6, "bodies")  # the transform rounds as well

    def open_stage(self, path):
        usd = reader(self, "pxr.Usd")
        stage = usd.Stage.Open(str(path))
        value = lambda path, frame: stage.GetAttributeAtPath(path).Get(frame)
        return usd, stage, value

    def test_usd_by_pixar(self):
        usd, stage, value = self.open_stage(self.out / "scene.usda")
        from pxr import UsdGeom, UsdShade

        self.assertEqual(UsdGeom.GetStageMetersPerUnit(stage), 1)
        self.assertEqual(UsdGeom.GetStageUpAxis(stage), "Y")
        self.assertEqual(stage.GetTimeCodesPerSecond(), 24)
        self.assertEqual((stage.GetStartTimeCode(), stage.GetEndTimeCode()), (0, FRAMES))
        for frame in range(FRAMES + 1):
            self.compare_usd(value, frame)
            self.compare_bodies(usd, stage, frame)
        sheet = stage.GetPrimAtPath("/scene/cloth/sheet")
        material, _ = UsdShade.MaterialBindingAPI(sheet).ComputeBoundMaterial()
        shader, _, _ = material.ComputeSurfaceSource()
        self.assert_same(shader.GetInput("diffuseColor").Get(), (0.8, 0.2, 0.1), "colour")
        self.assertEqual(UsdGeom.PrimvarsAPI(sheet).GetPrimvar("st").GetInterpolation(), "faceVarying")
        self.assertEqual(sheet.GetAttribute("points").GetNumTimeSamples(), FRAMES + 1)
        self.assertTrue(stage.GetPrimAtPath("/scene/shapes/tank").IsA(UsdGeom.Mesh))

    def test_an_interrupted_run_leaves_a_stage_with_the_frames_so_far(self):
        out = pathlib.Path(self.holder.name) / "killed"
        run = subprocess.Popen(run_of(out, "--frames", "1000", "--export", "ply,usd"))
        while not (out / f"frames/usd.{FRAMES:05}.usda").exists() and run.poll() is None:
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        text = UsdText(out / "scene.usda")
        last = int(text.metadata["endTimeCode"])
        self.assertGreaterEqual(last, FRAMES - 1)
        for frame in range(FRAMES):
            clip = UsdText(out / f"frames/usd.{frame:05}.usda")
            wanted = self.ply("surface", frame)["vertex"]["x"]
            found = sum(len(clip.value(f"/scene/surface/{name}.points", frame)) for name in FLUIDS[:2])
            self.assertEqual(found, len(wanted))
        _, stage, value = self.open_stage(out / "scene.usda")
        for frame in range(FRAMES):
            self.compare_usd(value, frame)
            self.compare_bodies(None, stage, frame)
        place = [value("/scene/bodies/crate__red.xformOp:translate", t)[1] for t in (1, 1.5, 2)]
        self.assertAlmostEqual(place[1], (place[0] + place[2]) / 2, 6, "bodies move between the frames")

    # ---- Alembic against PLY ----

    def test_alembic(self):
        reader(self, "alembic3d")
        from abc_archive import AbcArchive

        out = pathlib.Path(self.holder.name) / "abc"
        run = subprocess.run(run_of(out, "--frames", str(FRAMES), "--export", "abc"), capture_output=True, text=True)
        if "Alembic files cannot be written" in run.stderr:
            self.skipTest(run.stderr.strip())
        self.assertEqual(run.returncode, 0, run.stderr)
        archive = AbcArchive(out / "scene.abc", 24)
        self.assert_same(archive.times("/scene/particles/water"), [f / 24 for f in range(FRAMES + 1)], "times")
        for frame in range(FRAMES + 1):
            self.compare_usd(archive.value, frame)
            found = []
            for body in ("crate__red", "crate__red_2"):
                place = archive.transform(f"/scene/bodies/{body}", frame)
                found += [tuple(place(p)) for p in archive.value(f"/scene/bodies/{body}/mesh.points", 0)]
            wanted = vectors(self.ply("bodies", frame)["vertex"], *POSITION)
            self.assertEqual(len(found), len(wanted))
            for a, b in zip(flat(found), flat(wanted)):
                self.assertLessEqual(abs(a - b), 2e-6, "bodies")  # the transform rounds as well


if __name__ == "__main__":
    unittest.main(verbosity=2)
