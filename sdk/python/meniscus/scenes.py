# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Scene files and the samples that come with the package."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterable
from typing import Literal

from ._core import World, read_world
from .errors import FileError


def samples_folder() -> pathlib.Path:
    """Where the samples are: the folder that MENISCUS_SAMPLES_DIR names, or that of the package."""
    chosen = os.environ.get("MENISCUS_SAMPLES_DIR")
    return pathlib.Path(chosen) if chosen else pathlib.Path(__file__).parent / "scenes"


def sample_names() -> list[str]:
    """The names of the samples that load_scene takes."""
    return sorted(path.stem for path in samples_folder().glob("*.json"))


def scene_path(scene: str | os.PathLike[str]) -> str:
    """The path of a scene file, or of the sample with this name. Raises FileError."""
    text = os.fspath(scene)
    if os.path.exists(text):
        return text
    sample = samples_folder() / f"{text}.json"
    if os.sep not in text and sample.is_file():
        return str(sample)
    raise FileError(f"no scene file and no sample is called '{text}'; samples: {', '.join(sample_names())}")


def load_scene(scene: str | os.PathLike[str], *, device: str | None = None, threads: int | None = None,
               overrides: Iterable[str] = (),
               log: Callable[[Literal["note", "warning"], str], object] | None = None) -> World:
    """A world from a scene file or a sample, before its first frame.

    Overrides are texts such as "world.substeps=8", as --set takes them. A log is that of World. Raises
    FileError, SceneError and what World raises."""
    changes = list(overrides)
    if device is not None:
        changes.append(f"world.device={device}")
    if threads is not None:
        changes.append(f"world.threads={threads}")
    return read_world(scene_path(scene), changes, log)
