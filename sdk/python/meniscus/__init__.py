# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Liquids, cloth and rigid bodies by position-based dynamics, on the GPU and on the CPU.

Quantities are in SI units, and y points up unless gravity says otherwise."""

from . import _core, errors, pictures, results
from ._core import *  # noqa: F403
from ._core import World, list_devices, read_keyframes, scene_schema
from ._core import version as __version__
from .errors import *  # noqa: F403
from .errors import Error
from .rotations import axis_angle
from .scenes import load_scene, sample_names

__all__ = ["World", "Error", "load_scene", "sample_names", "list_devices", "read_keyframes", "scene_schema", "axis_angle",
           "errors", "pictures", "results", "__version__"]
__all__ += [name for name in vars(_core) if name[0].isupper()]
__all__ += [name for name in vars(errors) if name.endswith("Error")]
