# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Readers of our own for PLY, VTP, OBJ and USD text. They share nothing with the writers, and need Python alone.

import ast
import re
import struct
import xml.etree.ElementTree as ElementTree

PLY_TYPES = {"float": "f", "uint": "I", "int": "i", "uchar": "B"}
VTK_TYPES = {"Float32": "f", "UInt32": "I", "UInt64": "Q", "Int64": "q"}


def read_ply(path):
    """{element: {property: [value, ...]}}; a list property has a tuple a row."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    at, result = end, {}
    for name, count, properties in elements:
        columns = {p[-1]: [] for p in properties}
        for _ in range(count):
            for p in properties:
                if p[0] == "list":
                    (length,) = struct.unpack_from("<" + PLY_TYPES[p[1]], data, at)
                    at += struct.calcsize(PLY_TYPES[p[1]])
                    form = "<" + str(length) + PLY_TYPES[p[2]]
                    columns[p[-1]].append(struct.unpack_from(form, data, at))
                else:
                    form = "<" + PLY_TYPES[p[0]]
                    columns[p[-1]].append(struct.unpack_from(form, data, at)[0])
                at += struct.calcsize(form)
        result[name] = columns
    assert at == len(data), f"{path} has {len(data) - at} bytes too many"
    return result


def vectors(columns, *names):
    """[(x, y, z), ...] of properties."""
    return list(zip(*(columns[name] for name in names)))


def read_vtp(path):
    """{array: [tuple, ...]} of the points and cells of a PolyData file."""
    data = path.read_bytes()
    start = data.index(b"<AppendedData")
    first = data.index(b"_", start) + 1
    root = ElementTree.fromstring(data[:start] + b"</VTKFile>")
    result = {}
    for array in root.iter("DataArray"):
        if array.get("format") != "appended":
            continue
        at = first + int(array.get("offset"))
        (length,) = struct.unpack_from("<Q", data, at)
        kind, width = VTK_TYPES[array.get("type")], int(array.get("NumberOfComponents"))
        flat = struct.unpack_from(f"<{length // struct.calcsize(kind)}{kind}", data, at + 8)
        result[array.get("Name")] = [flat[i : i + width] for i in range(0, len(flat), width)]
    return result


def read_obj(path):
    """(vertices, faces), a face as [(vertex, texture coordinates or None), ...], from 0."""
    vertices, texture, faces = [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            vertices.append(tuple(map(float, rest)))
        elif word == "vt":
            texture.append(tuple(map(float, rest)))
        elif word == "f":
            corners = [(corner + "//").split("/") for corner in rest]
            faces.append([(int(c[0]) - 1, texture[int(c[1]) - 1] if c[1] else None) for c in corners])
    return vertices, faces


class UsdText:
    """Attributes of a stage by path, as in stage.value("/scene/cloth/sheet.points", 3)."""

    def __init__(self, path):
        self.metadata, self.attributes = {}, {}
        prims, name, in_metadata = [], None, False
        for line in path.read_text().splitlines():
            line = line.strip()
            prim = re.match(r'(?:def|over)\b.*"(\w+)"(?: \()?$', line)
            attribute = re.match(r"(?:uniform )?\S+ ([\w:]+)(?:\.\w+)? = (.*)$", line)
            if prim:
                name, in_metadata = prim[1], line.endswith("(")
            elif line in ("(", ")"):
                in_metadata = line == "("
            elif in_metadata:
                key, _, value = line.partition(" = ")
                self.metadata.setdefault(key, value)
            elif line == "{":
                prims.append(name)
            elif line == "}":
                prims.pop()
            elif attribute:
                key = "/" + "/".join(prims) + "." + attribute[1]
                self.attributes[key] = re.sub(r" \(interpolation = .*\)$", "", attribute[2])
        assert not prims, f"{path} is not complete"

    def value(self, attribute, time=None):
        value = ast.literal_eval(self.attributes[attribute])
        return value[time] if isinstance(value, dict) else value
