# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""What failing calls raise. Each class is also the built-in exception that Python's own calls would raise."""


class Error(Exception):
    """The base of all errors of Meniscus. The message names the argument, its value and what is allowed."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class InvalidArgumentError(Error, ValueError):
    """A value that the call does not allow."""


class NotFoundError(Error, KeyError):
    """A thing or a name that does not exist in this world."""


class FileError(Error, OSError):
    """A file that cannot be read or written."""


class SceneError(Error, ValueError):
    """A scene file with a wrong, missing or unknown key."""


class MeshError(Error, ValueError):
    """An unusable mesh: not valid, empty, degenerate or without an inside."""


class CapacityError(Error):
    """A fixed limit was reached. The message names it and the remedy."""


class NonFiniteError(Error, ArithmeticError):
    """The step met NaN, infinity or too high a speed. The state before the step is restored."""


class DeviceError(Error):
    """CUDA or the driver failed, or the requested device does not exist."""


class OutOfMemoryError(Error, MemoryError):
    """There is too little memory, on the host or on the device."""


class CancelledError(Error):
    """The call was cancelled by World.cancel. Nothing has changed."""


class LostError(Error):
    """An earlier call failed while it changed the world. Nothing of it is usable."""
