# SPDX-License-Identifier: GPL-3.0-or-later
"""What the checks of the house share: the project's own files, and how a check ends.

Each script takes the source directory as its argument, prints what is wrong, a line a place, and ends with 1;
with 77 (skipped) where the tool that it needs is not there.
"""
import pathlib
import re
import shutil
import subprocess
import sys

FOLDERS = ("Documentation", "Filters", "Plugin", "Readers", "Testing")
SKIPPED = 77


def root():
    return pathlib.Path(sys.argv[1]).resolve()


def files(*endings, folders=FOLDERS):
    """The project's files with one of these endings, in order; at least ten, or the check looks in the wrong place."""
    found = sorted(path for folder in folders for path in (root() / folder).rglob("*")
                   if path.suffix in endings and path.is_file() and "__pycache__" not in path.parts)
    if len(found) < 10:
        sys.exit(f"FAILED: only {len(found)} files in {', '.join(folders)} of {root()}: this looks in the wrong place.")
    return found


def name(path):
    return path.relative_to(root()).as_posix()


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(SKIPPED)


def tool(program):
    """The path of a program, or the end of the check where it is not there."""
    path = shutil.which(program)
    if not path:
        skip(f"{program} is not installed, so nothing was checked.")
    return path


def run(*command):
    """Runs a tool over the source directory and ends the check as the tool did; its words are the check's."""
    done = subprocess.run(command, cwd=root(), check=False)
    sys.exit(1 if done.returncode else 0)


def beside(file):
    """A file in the folder of the checks."""
    return pathlib.Path(__file__).with_name(file)


def pages():
    """The pages at the top."""
    return sorted(root().glob("*.md"))


def exceptions(file):
    """Lines of a list of exceptions beside the check, without comments."""
    lines = (line.split("#")[0].strip() for line in beside(file).read_text(encoding="utf-8").splitlines())
    return {line for line in lines if line}


def without_comments(text):
    """C++ text with comments and literals blanked, line for line."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''

    def blank(match):
        kept = match.group(0)
        if kept.startswith("/"):
            return "\n" * kept.count("\n") + " "
        return kept[0] + kept[-1]

    return re.sub(pattern, blank, text, flags=re.DOTALL)


def end(wrong, checked):
    for line in wrong:
        print(line)
    if wrong:
        sys.exit(f"FAILED: {len(wrong)} places.")
    print(f"{checked} files checked.")
