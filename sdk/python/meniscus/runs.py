# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Runs of many steps, with a bar where tqdm is installed."""

from __future__ import annotations

import importlib
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._core import StepReport, World


def steps(frames: int, progress: bool) -> Iterable[int]:
    """The numbers of the steps, shown as a bar in terminals and notebooks."""
    if progress:
        try:
            tqdm = importlib.import_module("tqdm.auto").tqdm
        except ImportError:
            print(f"meniscus: {frames} frames; for a bar: pip install tqdm")
        else:
            bar: Iterable[int] = tqdm(range(frames), unit="frame")
            return bar
    return range(frames)


def run(world: World, frames: int | None, dt: float | None, progress: bool) -> StepReport | None:
    """World.run."""
    if frames is not None and frames < 0:
        raise ValueError(f"run(): frames is {frames}; it must be at least 0")
    report = None
    for _ in steps(world.frames if frames is None else frames, progress):
        report = world.step(dt)
    return report
