# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation builds as a site without a warning, and has a page of every node with all that a user may set."""
import shutil
import subprocess
import sys
import tempfile

import house


def python_with_sphinx():
    """Debian's Python has Debian's Sphinx, whatever python3 comes first."""
    for python in (sys.executable, "/usr/bin/python3"):
        if shutil.which(python) and subprocess.run([python, "-c", "import sphinx, myst_parser"], capture_output=True,
                                                   check=False).returncode == 0:
            return python
    house.skip("python3-sphinx and python3-myst-parser are not installed, so no site was built.")


python = python_with_sphinx()
site = house.root() / "Documentation" / "site"
sys.path.insert(0, str(site))
import node_pages

wrong = []
with tempfile.TemporaryDirectory() as folder:
    done = subprocess.run([python, "-B", str(site / "build_site.py"), folder], capture_output=True, text=True, check=False)
    wrong += [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    if done.returncode:
        wrong.append("The site could not be built.")
    nodes = node_pages.read_nodes(house.root())
    for node in nodes:
        page = house.pathlib.Path(folder) / "html" / "Documentation" / "nodes" / f"{node.name}.html"
        text = page.read_text(encoding="utf-8") if page.exists() else ""
        wrong += [f"{node.name} has no page with {part.name}." for part in node.properties.values()
                  if part.is_shown and part.words and part.name not in text]
if len(nodes) < 20:
    wrong.append(f"Only {len(nodes)} nodes were found: this looks in the wrong place.")
house.end(wrong, len(nodes))
