"""Sphinx settings of the reference of the Python module; built by tests/reference/build."""

project = "rocking"
copyright = "the authors of rocking"
extensions = ["sphinx.ext.autodoc"]
html_theme = "basic"
nitpicky = False
autodoc_typehints = "description"
autodoc_member_order = "bysource"
exclude_patterns = []
