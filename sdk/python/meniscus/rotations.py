# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Rotations as quaternions."""

from __future__ import annotations

import math
from collections.abc import Sequence


def axis_angle(axis: Sequence[float], degrees: float) -> tuple[float, float, float, float]:
    """The quaternion (x, y, z, w) that turns about an axis by the right hand. The axis may have any length."""
    x, y, z = axis
    length = math.hypot(x, y, z)
    if not 0 < length < math.inf:
        raise ValueError(f"the axis {tuple(axis)} has no direction")
    if not math.isfinite(degrees):
        raise ValueError(f"{degrees} degrees are no angle")
    half = math.radians(degrees) / 2
    s = math.sin(half)
    return (s * (x / length), s * (y / length), s * (z / length), math.cos(half))
