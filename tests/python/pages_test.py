# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""The Python programs of the README, of docs/python.md and of the manual's concepts run as they stand."""

import contextlib
import importlib.util
import io
import os
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"])


def programs(page):
    return re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(encoding="utf-8"), re.S | re.M)


def run(text, names):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(text, "page", "exec"), names)
    return printed.getvalue()


class Pages(unittest.TestCase):
    def setUp(self):
        self.old = os.getcwd()
        self.folder = tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.old)
        self.folder.cleanup()

    def test_readme(self):
        (program,) = programs("README.md")
        self.assertLessEqual(len(program.splitlines()), 20)
        if importlib.util.find_spec("matplotlib") is None:
            program = program[: program.index("import matplotlib")]
        names = {}
        printed = run(program, names)
        self.assertRegex(printed, r"\d+ particles")
        # Half as dense as water: half of the crate is below the surface.
        self.assertAlmostEqual(names["crate"].position[1], names["level"].value - 0.6, delta=0.1)

    def test_python_page(self):
        found = programs("docs/python.md")
        self.assertGreaterEqual(len(found), 4)
        names = {}
        for program in found:
            run(program, names)

    def test_concepts(self):
        found = [program for page in sorted((ROOT / "docs/manual/concepts").glob("*.md")) for program in programs(page)]
        self.assertGreaterEqual(len(found), 1)
        for program in found:
            run(program, {})


if __name__ == "__main__":
    unittest.main()
