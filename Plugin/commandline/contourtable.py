# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables for people: columns, colours where there is a terminal, quantities with their units. Needs no ParaView."""
import math
import os

GREEN, RED, PLAIN = "\x1b[32m", "\x1b[31m", "\x1b[0m"
PAINT = {"yes": GREEN, "NO": RED, "done": GREEN, "FAILED": RED}


def coloured():
    """Whether colours are shown: on a terminal, unless the user wants none (https://no-color.org)."""
    return os.isatty(1) and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def paint(cell, shown):
    """A cell, padded already, in the colour of its word."""
    colour = PAINT.get(cell.strip()) if shown else None
    return f"{colour}{cell}{PLAIN}" if colour else cell


def format_table(rows, titles):
    """Columns as wide as their widest entry; the first is left-aligned."""
    cells = [titles] + [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[c]) for row in cells) for c in range(len(titles))]
    shown = coloured()
    lines = []
    for row in cells:
        padded = [row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        lines.append("  ".join(paint(cell, shown) for cell in padded).rstrip())
    lines.insert(1, "-" * (sum(widths) + 2 * (len(widths) - 1)))
    return "\n".join(lines)


def yes(value):
    return "-" if value is None else "yes" if value else "NO"


def quantity(value):
    if value is None or math.isnan(value):
        return "-"
    return f"{value:.7g}"


def volume(value, unit):
    """A volume in the unit that people speak of it in, and that unit: what is measured in mm is told in cm3."""
    if unit == "mm":
        return (None if value is None else value / 1000), "cm3"
    return value, f"{unit or 'unit'}3"
