# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Settings of Sphinx for the manual. docs/manual/build calls it; the source folder is the repository itself, so that
pages stand where they are and their links hold in a checkout too."""

import logging
import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE / "extensions"))
sys.path.insert(0, os.environ["MENISCUS_STUBS"])  # the stubs of the Python package, as modules

project = "Meniscus"
author = "The Meniscus authors"
version_header = (ROOT / "sdk/include/meniscus/version.h").read_text(encoding="utf-8")
version = release = ".".join(re.search(rf"VERSION_{part} (\d+)", version_header)[1]
                             for part in ("MAJOR", "MINOR", "PATCH"))
project_copyright = "2026 The Meniscus authors"

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "documented", "scene_keys",
              "gallery", "repository_links"]
root_doc = "docs/manual/index"
source_suffix = {".md": "markdown"}
include_patterns = ["README.md", "docs/*.md", "docs/methods/*.md", "docs/rivals/*/*.md", "docs/manual/**.md", "samples/README.md",
                    "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"]
exclude_patterns = ["build*", "out", ".git"]
nitpicky = True
# Types of the standard library, of NumPy, and of Doxygen's own making.
nitpick_ignore_regex = [("cpp:identifier", ".*"), ("c:identifier", ".*"), ("py:.*", ".*")]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = f"Meniscus {version}"
html_copy_source = False
smartquotes = False
templates_path = []

breathe_projects = {"cpp": os.environ["MENISCUS_XML"] + "/cpp", "c": os.environ["MENISCUS_XML"] + "/c"}
breathe_default_project = "cpp"
breathe_domain_by_file_pattern = {"*/meniscus/c/*.h": "c"}
breathe_show_include = False

autodoc_member_order = "bysource"
autodoc_docstring_signature = False
autodoc_typehints = "signature"
autoclass_content = "both"
napoleon_google_docstring = True
napoleon_numpy_docstring = False
autodoc_mock_imports = ["numpy"]


def setup(app):
    from pygments.lexers.special import TextLexer
    app.add_lexer("mermaid", TextLexer)
    # Each header opens the namespace again, which is no second declaration.
    logging.getLogger("sphinx.sphinx.domains.cpp").addFilter(
        lambda record: "Declaration is '.. cpp:type:: meniscus'" not in record.getMessage())
