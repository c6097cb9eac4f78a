# SPDX-License-Identifier: BSD-3-Clause
"""How Sphinx builds the manual. `docs/make` calls it with the folder of the build in KALOS_BUILD."""
import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ["KALOS_BUILD"])
sys.path.insert(0, str(Path(__file__).parent / "extensions"))

project = "Kalos"
author = copyright = "The Kalos authors"
version = release = re.search(r"^project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.graphviz", "sphinx_copybutton", "breathe", "kalos_manual"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["extensions"]
nitpicky = False

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
math_number_all = False
math_eqref_format = "({number})"

autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "none"
graphviz_output_format = "svg"
breathe_projects = {"kalos": str(BUILD / "docs" / "doxygen" / "xml")}
breathe_default_project = "kalos"
breathe_default_members = ("members",)
breathe_domain_by_extension = {"h": "cpp"}
cpp_id_attributes = []

html_theme = "furo"
html_title = f"Kalos {version}"
html_logo = "../apps/edge-studio/share/kalos.svg"
html_favicon = "../apps/edge-studio/share/kalos.svg"
html_static_path = ["static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "sidebar_hide_name": False,
    "light_css_variables": {"color-brand-primary": "#9a5b00", "color-brand-content": "#8a4f00"},
    "dark_css_variables": {"color-brand-primary": "#ffb454", "color-brand-content": "#ffb454"},
}
copybutton_prompt_text = "$ "
