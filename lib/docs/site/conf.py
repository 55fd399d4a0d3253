"""Sphinx settings of the site of documents. The source folder is the root of the repository; tests/reference/build calls it.

The index is lib/docs/README.md, with one for the background of it. Their headings and links are the navigation of the site,
so that no list of pages stands twice.
"""

import os
import re
from pathlib import Path

from pygments.lexers import PythonLexer, TextLexer

root = Path(__file__).resolve().parents[3]

project = "rocking"
copyright = "the authors of rocking"
html_title = "rocking"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc"]
breathe_projects = {"rocking": os.environ["ROCKING_REFERENCE"] + "/xml"}
breathe_default_project = "rocking"
breathe_show_include = False
nitpicky = True
nitpick_ignore_regex = [("py:class", ".*"), ("cpp:.*", ".*")]  # types of other libraries, and of headers that are not shown
root_doc = "lib/docs/README"
include_patterns = [
    "*.md",
    "lib/docs/**.md",
    "lib/docs/reference/*.rst",
    "experiments/*/README.md",
    "reports/**.md",
    "tests/reference/README.md",
]
exclude_patterns = ["build", "reports/local"]
html_theme = "alabaster"
html_theme_options = {
    "description": "How likely is each response of a rocking block?",
    "fixed_sidebar": True,
    "font_family": "sans-serif",
    "page_width": "auto",
    "sidebar_width": "18em",
}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_extra_path = ["extra", "../../../reports/live.html"]
myst_heading_anchors = 4  # as a repository's page has them
autodoc_mock_imports = ["rocking._core"]  # in C++; what is documented is in Python
autodoc_typehints = "description"
autodoc_member_order = "bysource"


def navigation(text, folder):
    """The text of an index, with a hidden table of contents of the pages to which it links below each of its headings."""
    lines = []
    for section in re.split(r"(?m)^(?=## )", text):
        heading = re.match(r"## (.*)\n", section)
        paths = [(folder / link).resolve() for link in re.findall(r"\]\(([^)#:]+\.(?:md|rst))\)", section)]
        pages = [f"/{path.relative_to(root).with_suffix('')}" for path in paths]
        lines += [section, "```{toctree}\n:hidden:", f":caption: {heading[1]}\n" if heading else "", *pages, "```\n"]
    return "\n".join(lines)


def add_navigation(app, docname, source):
    if docname in (root_doc, "lib/docs/background", "lib/docs/decisions/README"):
        source[0] = navigation(source[0], root / Path(docname).parent)


def name_folders(app, docname, source):
    """A link to a folder leads to its README, or else names it only: a folder is no page."""
    around = (root / docname).parent

    def page_of(link):
        readme = around / link[2] / "README"
        if not readme.parent.is_dir():
            return link[0]
        is_page = str(readme.resolve().relative_to(root)) in app.env.found_docs
        return f"[{link[1]}]({link[2]}/README.md)" if is_page else link[1]

    source[0] = re.sub(r"\[([^\[\]]*)\]\(([^)#:\s]+)\)", page_of, source[0])


def quote_names(app, what, name, obj, options, lines):
    """A name such as `from_` is no link, which to Sphinx ends so."""
    lines[:] = [re.sub(r"(?<![`\w])([a-z]+_)(?=[:,])", r"``\1``", line) for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", quote_names)
    app.connect("source-read", add_navigation)
    app.add_lexer("python-pandas", PythonLexer)  # tests/cli/loading_test.cpp tells it from other Python
    app.add_lexer("csv", TextLexer)  # Pygments 2.14 has none
    app.connect("source-read", name_folders)
    return {"parallel_read_safe": True}
