# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Each public name of the Python package has a docstring. Docstrings are plain text, in which bars are bars."""

import re

from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
MEMBER = re.compile(r"^\w+(?P<unit> \([^)]*\))?: (?P<meaning>.*)$")


def check(_app, what, name, _obj, _options, lines):
    words = " ".join(lines).strip()
    if not words or words.startswith("Alias for field number"):
        LOGGER.warning("the %s %s has no docstring", what, name)
    lines[:] = [line.replace("|", "\\|") for line in lines]
    if what in ("attribute", "property"):
        # "gravity (m/s²): acceleration": napoleon would take what stands before a colon for a type.
        member = MEMBER.match(lines[0]) if lines else None
        if member:
            lines[0] = member["meaning"] + (f"; in{member['unit'].translate(str.maketrans('', '', '()'))}"
                                            if member["unit"] else "")
        lines[:] = [line.replace(": ", " – ") for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", check, priority=400)  # before napoleon
    return {"parallel_read_safe": True, "parallel_write_safe": True}
