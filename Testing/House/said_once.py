# SPDX-License-Identifier: GPL-3.0-or-later
"""No ten lines of Filters and Readers stand in two places: what is needed twice is a function.

Blank lines, comments, includes and indentation do not count; nor do declarations of VTK properties (vtkSetMacro,
PrintSelf) and the names of choices, which the classes that Python sees cannot take from the core. Pairs of files that
must repeat themselves are in said_once.txt, with the reason.
"""
import re

import house

LINES = 10
NO_MATTER = re.compile(r"#|//|/?\*|vtk(Set|Get|Boolean)\w*Macro\(|os << |enum \w+$|\w+ = -?\d+,?$|\w+;$|using |}?;?$|public:|protected:|private:")


def code(path):
    """(number, text) of every line that counts."""
    lines = house.without_comments(path.read_text(encoding="utf-8")).splitlines()
    return [(number, line.strip()) for number, line in enumerate(lines, 1) if not NO_MATTER.match(line.strip())]


def main():
    sources = house.files(".h", ".cxx", folders=("Filters", "Readers"))
    first, wrong = {}, {}
    for path in sources:
        lines, said = code(path), 0
        for i in range(len(lines) - LINES + 1):
            words = tuple(text for _, text in lines[i:i + LINES])
            here = (path, lines[i][0])
            there = first.setdefault(words, here)
            if there != here and i >= said:
                pair = f"{house.name(there[0])} {house.name(path)}"
                wrong[pair] = f"{house.name(path)}:{here[1]} says again what {house.name(there[0])}:{there[1]} says."
                said = i + LINES
    known = house.exceptions("said_once.txt")
    lines = [sentence for pair, sentence in sorted(wrong.items()) if pair not in known]
    lines += [f"said_once.txt: '{pair}' is mended: take it from the list." for pair in sorted(known - wrong.keys())]
    house.end(lines, len(sources))


main()
