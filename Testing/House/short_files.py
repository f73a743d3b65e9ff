# SPDX-License-Identifier: GPL-3.0-or-later
"""No file of Filters and Readers has more than 600 lines: a longer one holds more than one thing."""
import house

LIMIT = 600

sources = house.files(".h", ".cxx", folders=("Filters", "Readers"))
wrong = []
for path in sources:
    lines = len(path.read_text(encoding="utf-8").splitlines())
    if lines > LIMIT:
        wrong.append(f"{house.name(path)} has {lines} lines, more than {LIMIT}.")
house.end(wrong, len(sources))
