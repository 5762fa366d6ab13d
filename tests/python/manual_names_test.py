# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Names of the interface that the manual's pages mention exist: in the public headers, in Python, in scene files or as samples."""

import os
import pathlib
import re
import unittest

import meniscus

ROOT = pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"])
MANUAL = ROOT / "docs/manual"
# Names with an underscore or a scope; file names, commands and other tools' names are left out.
NAME = re.compile(r"^[A-Za-z]\w*(?:(?:::|\.)\w+)*(?:\(.*\))?$")
OTHERS = {"add_subdirectory", "find_package", "from_numpy", "np_random"}  # of CMake, torch and Gymnasium


def known_words():
    headers = (ROOT / "sdk/include/meniscus").rglob("*.h")
    package = pathlib.Path(meniscus.__file__).parent
    sources = [*headers, package / "_core.pyi", *package.glob("*.py"), ROOT / "samples/scene.schema.json"]
    samples = {path.stem for path in (ROOT / "samples/scenes").glob("*.json")}
    return samples | set(re.findall(r"\w+", "\n".join(path.read_text(encoding="utf-8") for path in sources)))


def names_of(path):
    """Names in inline code. The first column of the pages for newcomers has names of other packages."""
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.S | re.M)
    foreign = path.parent.name == "coming_from"
    for line in text.splitlines():
        cells = line.split("|")[2:] if foreign and line.startswith("|") else [] if foreign else [line]
        for code in re.findall(r"`([^`]+)`", " ".join(cells)):
            name = code.split("(")[0].split(".")[-1]  # before a point stands a variable
            if NAME.match(code) and ("_" in name or "::" in name) and name not in OTHERS:
                yield from name.split("::")


class Names(unittest.TestCase):
    def test_exist(self):
        known, checked = known_words(), 0
        for path in sorted(MANUAL.rglob("*.md")):
            for name in names_of(path):
                checked += 1
                self.assertTrue(name in known or name.endswith("_"), f"{path.relative_to(ROOT)}: {name} does not exist")
        self.assertGreater(checked, 150)


if __name__ == "__main__":
    unittest.main()
