# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the manual page of contour-reconstruct, made of the parser that its help is made of.

    python3 manpage.py VERSION > contour-reconstruct.1
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contouroptions

SECTIONS = (
    ("FORMATS", "Read: {read}. Those that ParaView reads by itself: {others}. Surfaces are written to {written}; the "
                "contours of all slices, by --method ism, to {contours}; contours as they are to {kept}."),
    ("SEVERAL FILES", "One that fails does not keep the others from being done: it is named at the end, and the exit status is 1. "
                      "Each file is worked on in a process that lives on for the next; one that ends in the middle costs its file. "
                      "--summary has an entry a file: File, Status (done, nothing, failed, not tried), Error, Notes, and Regions with "
                      "Name, Status, Output, Unit, Contours, Triangles, Closed, Manifold, CrossingPairs, Volume, Area, Seconds and Notes."),
    ("ENVIRONMENT", "CONTOUR_PVPYTHON: the pvpython to use. CONTOUR_PLUGIN: the plugin to use. NO_COLOR: no colours; there are none "
                    "where the output is no terminal."),
)


def escaped(text):
    """Plain text for roff: hyphens that may be typed, no line that begins like a request."""
    lines = text.replace("\\", "\\e").replace("-", "\\-").splitlines()
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in lines)


def option(action):
    """One option: its names with what they take, and its help."""
    takes = action.metavar or ("|".join(action.choices) if action.choices else "")
    takes = takes + " ..." if action.nargs == "+" else takes
    names = ", ".join(f"\\fB{escaped(name)}\\fR" for name in action.option_strings) or f"\\fI{escaped(takes)}\\fR"
    if action.option_strings and takes:
        names += f" \\fI{escaped(takes)}\\fR"
    return f".TP\n{names}\n{escaped((action.help or '').replace('%%', '%'))}\n"


def page(version):
    parser = contouroptions.make_parser()
    about = {"read": " ".join(contouroptions.READERS), "others": " ".join(contouroptions.PARAVIEW_FORMATS),
             "written": " ".join(contouroptions.SURFACE_FORMATS), "contours": contouroptions.STRUCTURE_SET, "kept": " ".join(contouroptions.CONTOUR_FORMATS)}
    ways = [line.strip() for line in contouroptions.USAGE.splitlines()]
    head, _, examples = contouroptions.EPILOG.partition("\n\nExamples:\n")
    examples, _, status = examples.partition("\n\nExit status: ")
    parts = [f'.TH CONTOUR\\-RECONSTRUCT 1 "" "Contour Reconstruction {version}" "User Commands"',
             ".SH NAME", "contour\\-reconstruct \\- " + escaped(contouroptions.DESCRIPTION[0].lower() + contouroptions.DESCRIPTION[1:-1]),
             ".SH SYNOPSIS", "\n.br\n".join(escaped(way.replace("%(prog)s", "contour-reconstruct")) for way in ways),
             ".SH DESCRIPTION", escaped(contouroptions.DESCRIPTION + "\n" + head),
             ".SH OPTIONS", "".join(option(action) for action in parser._actions).rstrip()]
    for title, text in SECTIONS:
        parts += [f".SH {title}", escaped(text.format(**about))]
    parts += [".SH EXAMPLES", ".nf", escaped("\n".join(line.strip() for line in examples.splitlines())), ".fi",
              ".SH EXIT STATUS", escaped(status)]
    return "\n".join(parts) + "\n"


if __name__ == "__main__":
    sys.stdout.write(page(sys.argv[1] if len(sys.argv) > 1 else ""))
