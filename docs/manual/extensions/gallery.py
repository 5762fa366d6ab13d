# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""The directive `gallery`: each sample with its description, and with its picture where docs/manual/make_gallery has made
one."""

import json
import os
import pathlib
import re

from docutils import nodes
from docutils.parsers.rst import Directive


def read_scene(path):
    """A scene file, without its comments."""
    text = re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.M)
    return json.loads(re.sub(r'(?<=[\]},"0-9])\s+//.*$', "", text, flags=re.M))


class Gallery(Directive):
    """Pictures lie in the folder that MENISCUS_GALLERY names, below the repository."""

    def run(self):
        env = self.state.document.settings.env
        root, pictures = pathlib.Path(env.srcdir), pathlib.Path(os.environ["MENISCUS_GALLERY"])
        result = []
        for path in sorted((root / "samples/scenes").glob("*.json")):
            env.note_dependency(str(path))
            scene = read_scene(path)
            section = nodes.section(ids=[nodes.make_id(path.stem)])
            section += nodes.title("", path.stem)
            section += nodes.paragraph("", scene["description"])
            picture = pictures / f"{path.stem}.png"
            env.note_dependency(str(picture))
            if picture.exists():
                section += nodes.image(uri="/" + str(picture.relative_to(root)), alt=f"the sample {path.stem}")
            result.append(section)
        return result


def setup(app):
    app.add_directive("gallery", Gallery)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
