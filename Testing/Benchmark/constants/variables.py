# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of the core in which every tuned constant is a variable, so that a program can sweep it without a rebuild.

    variables.py CORE_DIRECTORY OUTPUT_DIRECTORY
    variables.py CORE_DIRECTORY --list

`constexpr double Name = value;` becomes a reference to a value that Variable.h keeps a register of. The product itself is
built from the sources as they are and knows nothing of this. Constants that the compiler must know (sizes of arrays,
template arguments), and those that are no matter of taste (Pi, -1 for "none"), stay as they are. Of a
structure of numbers the first one is varied. --list names the sources that have such constants, in them or in the header of
their name, which a program must be built of; the rest may come from the library.
"""
import os
import re
import sys

CONSTANT = re.compile(r"^(\s*)(static |inline )?constexpr (double|int|std::size_t|std::uint64_t|std::int64_t|float) (\w+) = ([^;]+);(.*)$")
LIST = re.compile(r"^(\s*)(static |inline )?constexpr (double|int) (\w+)\[\] = \{ ([^;]+) \};(.*)$")
STRUCTURE = re.compile(r"^(\s*)(static |inline )?constexpr ([A-Z]\w+) (\w+)\{ ([^{};]+) \};(.*)$")
# No matter of taste: mathematics, names for "none", and limits of a number's bits.
FIXED = {"Pi", "DegreesPerRadian", "RadiansPerDegree", "infinity", "Infinity", "Outside", "NoContour", "NoGroup", "None", "Unset", "bothSides",
         "Deepest", "DeepestLevel", "MaximumCells", "DefectAnyError"}
SIZE = re.compile(r"(?:array<[^;{}()]*?\b{0}\b|\[[^\]\n]*\b{0}\b[^\]\n]*\]|Matrix<[^;{}()]*?\b{0}\b|<{0}>|case {0}\b)"
                  .replace("{0}", "NAME"))


def structural(name, text):
    """Whether the compiler must know it, or something that it must know is made of it."""
    if re.search(SIZE.pattern.replace("NAME", name), text):
        return True
    made = re.findall(r"constexpr [\w:]+ (\w+) = [^;]*\b" + name + r"\b[^;]*;", text)
    return any(structural(other, text) for other in made)


def changed(place, text, whole):
    lines = []
    for line in text.split("\n"):
        found = CONSTANT.match(line)
        several = LIST.match(line)
        structure = STRUCTURE.match(line)
        if found and found.group(4) not in FIXED and not structural(found.group(4), whole):
            indent, prefix, kind, name, value, rest = found.groups()
            line = f'{indent}{storage(place, indent, prefix)}const {kind}& {name} = variables::Add<{kind}>("{place}", "{name}", {value});{rest}'
        elif several:
            indent, prefix, kind, name, values, rest = several.groups()
            line = (f'{indent}{storage(place, indent, prefix)}const auto& {name} = '
                    f'variables::AddList<{kind}>("{place}", "{name}", {{ {values} }});{rest}')
        elif structure:
            indent, prefix, kind, name, values, rest = structure.groups()
            line = (f'{indent}{storage(place, indent, prefix)}const {kind}& {name} = '
                    f'variables::AddStructure<{kind}>("{place}", "{name}", {{ {values} }});{rest}')
        elif "constexpr std::array<" in line and "{" in line:
            # It may be made of what is a variable now.
            line = line.replace("constexpr std::array<", "const std::array<", 1)
        lines.append(line)
    made = "\n".join(lines)
    return made if made == text else made.replace("#include", '#include "Variable.h"\n#include', 1)


def storage(place, indent, prefix):
    """Static members of classes, and what headers hold, must be inline."""
    if (prefix or "").startswith("static"):
        return "static inline " if indent or place.endswith(".h") else "static "
    return "inline " if place.endswith(".h") else "static "


def read(core):
    texts = {}
    for folder, _, names in os.walk(core):
        for name in names:
            if name.endswith((".h", ".cxx")):
                path = os.path.join(folder, name)
                with open(path, encoding="utf-8") as stream:
                    texts[os.path.relpath(path, core)] = stream.read()
    return texts


def write_changed(path, text):
    if os.path.exists(path):
        with open(path, encoding="utf-8") as stream:
            if stream.read() == text:
                return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def main():
    core, output = sys.argv[1:3]
    texts = read(core)
    headers = "\n".join(text for place, text in texts.items() if place.endswith(".h"))
    everything = "\n".join(texts.values())
    made = {place: changed(place, text, everything if place.endswith(".h") else text + headers) for place, text in texts.items()}
    if output == "--list":
        for place in sorted(texts):
            of_its_name = (place, place[:-len(".cxx")] + ".h")
            if place.endswith(".cxx") and any("variables::Add" in made.get(one, "") for one in of_its_name):
                print(place)
        return
    for place, text in made.items():
        write_changed(os.path.join(output, place), text)


main()
