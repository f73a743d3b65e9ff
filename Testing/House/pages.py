# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages: links lead somewhere, code that is shown is the file that a test runs, each `./run COMMAND` is one, also in
what a public host and Docker are told, and README stays short.

A code block below a comment `file: NAME` must be that file, letter for letter.
"""
import re

import house

README_WORDS = 900

pages = house.pages() + sorted((house.root() / "Documentation").rglob("*.md")) + sorted(
    (house.root() / "Data").glob("*.md"))
wrong = []
for page in pages:
    text = page.read_text(encoding="utf-8")
    for name, shown in re.findall(r"<!-- file: (\S+) -->\n```\w*\n(.*?)```", text, flags=re.DOTALL):
        if shown != (page.parent / name).read_text(encoding="utf-8"):
            wrong.append(f"{house.name(page)} shows another {name} than there is.")
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", re.sub(r"```.*?```", "", text, flags=re.DOTALL)):
        if not re.match(r"https?://", target) and not (page.parent / target).exists():
            wrong.append(f"{house.name(page)} links to {target}, which is not there.")
words = len((house.root() / "README.md").read_text(encoding="utf-8").split())
if words > README_WORDS:
    wrong.append(f"README.md has {words} words, more than {README_WORDS}.")
commands = set(re.findall(r"^  (\w+)\) ", (house.root() / "run").read_text(encoding="utf-8"), flags=re.MULTILINE))
told = [house.root() / "Dockerfile", *(house.root() / ".github").rglob("*.yml")]
for page in pages + told:
    for command in re.findall(r"/run ([a-z]+)", page.read_text(encoding="utf-8")):
        if command not in commands | {"help"}:
            wrong.append(f"{house.name(page)} tells of ./run {command}, which is no command.")
if len(told) < 2 or len(commands) < 10:
    wrong.append(f"Only {len(told)} files tell others to run something, and run has {len(commands)} commands.")
if len(pages) < 8:
    wrong.append(f"Only {len(pages)} pages were found: this looks in the wrong place.")
house.end(wrong, len(pages))
