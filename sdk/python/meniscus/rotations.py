# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Rotations as quaternions."""

from __future__ import annotations

import math
from collections.abc import Sequence


def axis_angle(axis: Sequence[float], degrees: float) -> tuple[float, float, float, float]:
    """The quaternion (x, y, z, w) that turns about an axis by the right hand. The axis may have any length."""
    x, y, z = axis
    length = math.sqrt(x * x + y * y + z * z)
    if not length > 0:
        raise ValueError(f"the axis {tuple(axis)} has no direction")
    half = math.radians(degrees) / 2
    s = math.sin(half) / length
    return (s * x, s * y, s * z, math.cos(half))
