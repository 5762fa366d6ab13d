# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""An Alembic archive, read by the package alembic3d, with the names that USD has for its values."""

import imath  # of alembic3d
from alembic3d import AbcGeom
from alembic3d.Abc import IArchive, ISampleSelector


def rows(values):
    return [tuple(value) for value in values]


def reversed_corners(values):
    """Of triangles, whose order Alembic has the other way round."""
    values = list(values)
    return [x for k in range(0, len(values), 3) for x in (values[k], values[k + 2], values[k + 1])]


class AbcArchive:
    def __init__(self, path, rate):
        self.archive, self.rate = IArchive(str(path)), rate

    def at(self, frame):
        return ISampleSelector(float(frame) / self.rate)

    def object(self, path):
        found = self.archive.getTop()
        for name in path.strip("/").split("/"):
            parent, found = found, found.getChild(name)
            if not found.valid():
                raise KeyError(path)
        return parent, name

    def value(self, attribute, frame):
        """That of "/scene/cloth/NAME.points" and the like."""
        path, _, name = attribute.partition(".")
        kind = {"particles": AbcGeom.IPoints, "diffuse": AbcGeom.IPoints, "ropes": AbcGeom.ICurves}.get(
            path.split("/")[2], AbcGeom.IPolyMesh)
        schema = kind(*self.object(path)).getSchema()
        at = self.at(frame)
        sample = schema.getValue(at)
        if name == "points":
            return rows(sample.getPositions())
        if name == "velocities":
            return rows(sample.getVelocities())
        if name == "ids":
            return list(sample.getIds())
        if name == "faceVertexIndices":
            return reversed_corners(sample.getFaceIndices())
        if name == "faceVertexCounts":
            return list(sample.getFaceCounts())
        param = {"widths": "getWidthsParam", "normals": "getNormalsParam", "primvars:st": "getUVsParam"}[name]
        values = getattr(schema, param)().getExpandedValue(at).getVals()
        if name == "primvars:st":
            return reversed_corners(rows(values))
        return list(values) if name == "widths" else rows(values)

    def transform(self, path, frame):
        """Of an object alone, as a function of a point."""
        matrix = AbcGeom.IXform(*self.object(path)).getSchema().getValue(self.at(frame)).getMatrix()
        return lambda point: imath.V3d(*point) * matrix

    def times(self, path):
        schema = AbcGeom.IPoints(*self.object(path)).getSchema()
        sampling = schema.getTimeSampling()
        return [sampling.getSampleTime(i) for i in range(schema.getNumSamples())]
