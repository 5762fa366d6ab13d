# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""The reader of PLY files that the script for Blender uses, and the files that samples/figure/make_walk writes."""
import importlib.machinery
import importlib.util
import struct
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
sys.dont_write_bytecode = True
sys.path.insert(0, str(SAMPLES / "blender"))
import ply  # noqa: E402


def text_of(*lines):
    return ("ply\nformat binary_little_endian 1.0\n" + "".join(line + "\n" for line in lines) + "end_header\n").encode()


class PlyTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name) / "surface_00007.ply"

    def tearDown(self):
        self.folder.cleanup()

    def test_reads_vertices_velocities_and_lists(self):
        header = text_of("element vertex 3", "property float x", "property float y", "property float z",
                         "property float vx", "property float vy", "property float vz", "element face 2",
                         "property list uchar uint vertex_indices", "property uint fluid",
                         "property list uchar float texcoord")
        vertices = b"".join(struct.pack("<6f", *range(k, k + 6)) for k in range(3))
        faces = b"".join(struct.pack("<B3IIB6f", 3, *corners, 5, 6, *range(6)) for corners in ((0, 1, 2), (2, 1, 0)))
        self.path.write_bytes(header + vertices + faces)
        read = ply.read_ply(self.path)
        self.assertEqual(read["face"]["vertex_indices"].tolist(), [[0, 1, 2], [2, 1, 0]])
        self.assertEqual(read["face"]["fluid"].tolist(), [5, 5])
        moving = ply.vectors(read["vertex"], ("vx", "vy", "vz"))
        self.assertEqual(moving.tolist(), [[3, 4, 5], [4, 5, 6], [5, 6, 7]])
        self.assertIsNone(ply.vectors(read["vertex"], ("nx", "ny", "nz")))
        self.assertEqual(ply.z_up(moving).tolist()[0], [3, -5, 4])
        self.assertEqual(ply.numbered(self.folder.name, "surface"), {7: self.path})

    def test_refuses_what_is_not_whole(self):
        self.path.write_bytes(text_of("element vertex 2", "property float x") + bytes(4))
        with self.assertRaisesRegex(ValueError, "ends too early"):
            ply.read_ply(self.path)
        self.path.write_bytes(b"solid")
        with self.assertRaisesRegex(ValueError, "no PLY file"):
            ply.read_ply(self.path)
        self.path.write_bytes(text_of("element face 2", "property list uchar uchar vertex_indices") +
                              bytes([1, 0, 2, 0]))
        with self.assertRaisesRegex(ValueError, "several lengths"):
            ply.read_ply(self.path)

    def test_an_empty_surface_has_no_faces(self):
        self.path.write_bytes(text_of("element vertex 0", "property float x", "element face 0",
                                      "property list uchar uint vertex_indices"))
        self.assertEqual(len(ply.read_ply(self.path)["face"]), 0)


class WalkTest(unittest.TestCase):
    """The committed files are those that the script writes, but for the last digits of sines."""

    def test_the_script_makes_the_files(self):
        loader = importlib.machinery.SourceFileLoader("make_walk", str(SAMPLES / "figure" / "make_walk"))
        script = importlib.util.module_from_spec(importlib.util.spec_from_loader("make_walk", loader))
        loader.exec_module(script)
        with tempfile.TemporaryDirectory() as folder:
            script.main(folder)
            made = sorted(Path(folder).iterdir())
            self.assertEqual(len(made), 25)
            for path in made:
                new, old = ply.read_ply(path), ply.read_ply(SAMPLES / "scenes" / "walk" / path.name)
                self.assertTrue(numpy.array_equal(new["face"], old["face"]))
                apart = ply.vectors(new["vertex"], "xyz") - ply.vectors(old["vertex"], "xyz")
                self.assertLess(numpy.abs(apart).max(), 1e-6)

    def test_the_figure_is_closed(self):
        read = ply.read_ply(SAMPLES / "scenes" / "walk" / "walk_01.ply")
        edges = {}
        for corners in read["face"]["vertex_indices"].tolist():
            for a, b in zip(corners, corners[1:] + corners[:1]):
                edges[(a, b)] = edges.get((a, b), 0) + 1
        self.assertTrue(all(n == 1 and (b, a) in edges for (a, b), n in edges.items()))


if __name__ == "__main__":
    unittest.main()
