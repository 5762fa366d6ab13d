# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Reads the PLY files of a run with NumPy alone."""
import re
from pathlib import Path

import numpy

TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4",
         "double": "<f8", "int8": "i1", "uint8": "u1", "int16": "<i2", "uint16": "<u2", "int32": "<i4",
         "uint32": "<u4", "float32": "<f4", "float64": "<f8"}


def read_header(data, path):
    """Elements as (name, count, [(property, type, type of count or None)]), and where the data begin."""
    end = data.find(b"end_header\n")
    if not data.startswith(b"ply\n") or end < 0:
        raise ValueError(f"{path} is no PLY file")
    elements = []
    for line in data[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"] and words[1] != "binary_little_endian":
            raise ValueError(f"{path} is not in the format binary_little_endian")
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append((words[4], TYPES[words[3]], TYPES[words[2]]))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[2], TYPES[words[1]], None))
    return elements, end + len(b"end_header\n")


def row_type(data, at, properties):
    """The type of the rows of an element. All its lists of one name are as long as that of the first row."""
    fields = []
    for key, kind, of_count in properties:
        if of_count:
            begin = at + numpy.dtype(fields).itemsize
            fields.append((key + " count", of_count))
            fields.append((key, kind, (int(numpy.frombuffer(data, of_count, 1, begin)[0]),)))
        else:
            fields.append((key, kind))
    return numpy.dtype(fields)


def read_ply(path):
    """Arrays of structures by the name of their element. A list is a column of rows, as long as each other."""
    data = Path(path).read_bytes()
    elements, at = read_header(data, path)
    read = {}
    for name, count, properties in elements:
        rows = row_type(data, at, properties) if count else numpy.dtype([])
        if len(data) < at + count * rows.itemsize:
            raise ValueError(f"{path} ends too early")
        read[name] = numpy.frombuffer(data, rows, count, at) if count else numpy.zeros(0, rows)
        for key, _, of_count in properties if count else ():
            if of_count and numpy.any(read[name][key + " count"] != rows[key].shape[0]):
                raise ValueError(f"{path} has lists of several lengths in {key}")
        at += count * rows.itemsize
    return read


def vectors(rows, keys):
    """An array of three columns, or None without these properties."""
    if not set(keys) <= set(rows.dtype.names or ()):
        return None
    return numpy.stack([rows[key] for key in keys], axis=1).astype(numpy.float32)


def z_up(points):
    """Meniscus has y up, and Blender z."""
    return numpy.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)


def numbered(folder, name):
    """The files NAME_00000.ply of a run, by their number."""
    found = {}
    for path in Path(folder).iterdir():
        match = re.fullmatch(re.escape(name) + r"_(\d{5,})\.ply", path.name)
        if match:
            found[int(match.group(1))] = path
    return dict(sorted(found.items()))
