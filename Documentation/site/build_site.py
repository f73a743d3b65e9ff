# SPDX-License-Identifier: GPL-3.0-or-later
"""Build the documentation as a site: the pages of this folder, README and tables, and a page a node.

    python3 build_site.py OUTPUT     the site is then OUTPUT/html/index.html

Needs Sphinx and MyST (Debian: python3-sphinx, python3-myst-parser). Every warning is an error: a link that leads nowhere,
a page that is in no list.
"""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys

import node_pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONF = """project = "Contour Reconstruction for ParaView"
author = "Contour Reconstruction"
extensions = ["myst_parser"]
myst_heading_anchors = 3
html_theme = "alabaster"
html_theme_options = {"page_width": "1100px", "sidebar_width": "240px",
                      "description": "Planar contours in, closed surfaces out"}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_show_sphinx = False
exclude_patterns = []
"""
LISTS = (("Use it", ["README", "Documentation/installation", "Documentation/package", "Documentation/recipes", "Documentation/stages", "Documentation/choosing",
                     "Documentation/fair-surface", "Documentation/topology", "Documentation/formats", "Documentation/command-line", "Documentation/python",
                     "Documentation/structure-sets", "Documentation/ranks", "Documentation/examples", "Documentation/gallery",
                     "Documentation/nodes", "Documentation/nodes/index"]),
         ("What it is worth", ["Data/TRUTH", "Data/TRUTH_IMPLICIT", "Data/TRUTH_FAIR", "Data/CERTIFICATES", "Data/PLANES", "Data/VOLUMES",
                               "Documentation/comparison", "Documentation/performance"]),
         ("How it works", ["Documentation/architecture", "Documentation/glossary", "Documentation/references",
                           "Documentation/library", "Data/CONSTANTS", "Data/README", "CONTRIBUTING", "SECURITY", "CHANGELOG"]))
# What pages show or link to beside pages: it is brought along, so that the links lead somewhere.
BESIDE = re.compile(r"\]\(([^)#\s]+)")


def pages():
    found = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")]
    return found + sorted((ROOT / "Documentation").glob("*.md")) + sorted((ROOT / "Data").glob("*.md"))


def copy(path, target):
    place = target / path.relative_to(ROOT)
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, place)


def copy_pages(target):
    """All pages, in folders as they are, with the pictures and files that they link to."""
    for page in pages():
        copy(page, target)
        for link in BESIDE.findall(page.read_text(encoding="utf-8")):
            beside = (page.parent / link).resolve()
            if not link.startswith("http") and beside.is_file() and beside.suffix != ".md":
                copy(beside, target)
    pictures = ROOT / "Documentation" / "pictures"
    for picture in pictures.rglob("*.png"):
        copy(picture, target)


def write_index(target):
    listed = {name for _, names in LISTS for name in names}
    others = sorted(page.relative_to(ROOT).with_suffix("").as_posix() for page in pages())
    lists = LISTS + (("More", [name for name in others if name not in listed]),)
    parts = ["# Contour Reconstruction for ParaView", "Planar contours in, closed surfaces out.",
             "![The window](Documentation/pictures/window.png)"]
    for title, names in lists:
        there = [name for name in names if (target / f"{name}.md").exists()]
        if there:
            parts += ["```{toctree}\n:caption: " + title + "\n:maxdepth: 1\n\n" + "\n".join(there) + "\n```"]
    (target / "index.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")


def main(output):
    source = output / "source"
    shutil.rmtree(output, ignore_errors=True)
    source.mkdir(parents=True)
    copy_pages(source)
    node_pages.write_pages(ROOT, source / "Documentation" / "nodes")
    write_index(source)
    (source / "conf.py").write_text(CONF, encoding="utf-8")
    sphinx = [sys.executable, "-m", "sphinx"] if importlib.util.find_spec("sphinx") else ["sphinx-build"]
    done = subprocess.run(sphinx + ["-W", "--keep-going", "-q", "-b", "html", str(source), str(output / "html")], check=False)
    return done.returncode


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: build_site.py OUTPUT")
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
