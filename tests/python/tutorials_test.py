# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""tutorials_test.py PROGRAM: runs a tutorial of the manual. It must end well and make the pictures that its page shows.
Skipped where a package is missing that it imports, or the program meniscus that it runs."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

MANUAL = pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"]) / "docs/manual"
SKIPPED = 77


def missing(text):
    """A package that the tutorial imports, or the program, if it is not here."""
    names = set(re.findall(r"^(?:import|from) (\w+)", text, re.M)) - {"__future__"}
    absent = sorted(name for name in names if importlib.util.find_spec(name) is None)
    if "MENISCUS_PROGRAM" in text and not os.environ.get("MENISCUS_PROGRAM"):
        absent.append("meniscus, the program")
    return absent


def main():
    program = MANUAL / "tutorials" / sys.argv[1]
    absent = missing(program.read_text(encoding="utf-8"))
    if absent:
        print("missing:", ", ".join(absent))
        return SKIPPED
    page = (MANUAL / "tutorials" / program.with_suffix(".md").name).read_text(encoding="utf-8")
    pictures = re.findall(r"!\[[^\]]*\]\(\.\./pictures/([\w.]+)\)", page)
    command = [str(program)] if program.suffix == ".sh" else [sys.executable, str(program)]
    with tempfile.TemporaryDirectory() as folder:
        status = subprocess.run(command, cwd=folder, check=False).returncode
        made = [picture for picture in pictures if (pathlib.Path(folder) / picture).stat().st_size > 1000]
    if not pictures or made != pictures or f"{{literalinclude}} {program.name}" not in page:
        print(f"the page must hold the program, and show pictures that it makes: {pictures}")
        return 1
    return status


if __name__ == "__main__":
    sys.exit(main())
