# SPDX-License-Identifier: GPL-3.0-or-later
"""What X.h declares, X.cxx defines: functions, and members of classes, of the core and the readers.

A reader who looks for a function then needs its header only.
"""
import re

import house

NO_NAMES = {"alignas", "decltype", "noexcept", "sizeof", "static_assert"}
CALL = re.compile(r"((?:\w+::)*~?\w+|(?:\w+::)*operator\s*\S{1,3}?)\s*\(")


def statements(text):
    """(statement before ; or {, whether a body follows), outside of all bodies but those of named namespaces."""
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE)
    depth, start, found = 0, 0, []
    hidden = 0  # depth from which a body, or a namespace without a name, hides everything
    for match in re.finditer(r"[{};]", text):
        sign, before = match.group(0), text[start:match.start()].strip()
        if sign == "{":
            if not hidden:
                if not re.fullmatch(r"(inline\s+)?namespace\s+[\w:]+", before):
                    hidden = depth + 1
                    found.append((before, True))
            depth += 1
        elif sign == "}":
            if hidden == depth:
                hidden = 0
            depth -= 1
        elif not hidden and before:
            found.append((before, False))
        if not hidden or sign != ";":
            start = match.end()
    return found


def function(statement):
    """Name of the function that a statement declares or begins, or None."""
    statement = re.sub(r"\[\[.*?\]\]|__attribute__\s*\(\(.*?\)\)\)?", " ", statement, flags=re.DOTALL)
    if re.match(r"(template\s*<[^{;]*>\s*)?(class|struct|enum|union|using|typedef|extern)\b", statement):
        return None
    if re.match(r"[^(]*[^=!<>]=[^=]", statement):
        return None  # a variable with a value
    for match in CALL.finditer(statement):
        name = match.group(1)
        if name not in NO_NAMES and not name.isupper():  # no macro either
            return name
    return None


def classes(text):
    return re.findall(r"^(?:class|struct)(?:\s+[A-Z_]+)?\s+(\w+)[^;{]*\{", text, flags=re.MULTILINE)


def declarations(path):
    text = house.without_comments(path.read_text(encoding="utf-8"))
    names = {function(statement) for statement, body in statements(text) if not body}
    return names - {None}, set(classes(text))


def definitions(path):
    text = house.without_comments(path.read_text(encoding="utf-8"))
    return [name for name in (function(s) for s, body in statements(text) if body) if name]


def main():
    headers = house.files(".h", folders=("Filters", "Readers"))
    sources = house.files(".cxx", folders=("Filters", "Readers"))
    declared_in, class_in = {}, {}
    for header in headers:
        functions, types = declarations(header)
        for name in functions:
            declared_in.setdefault(name, set()).add(header)
        for name in types:
            class_in.setdefault(name, set()).add(header)
    wrong, pairs = [], 0
    for source in sources:
        for name in definitions(source):
            owner = name.split("::")[-2] if "::" in name else None
            homes = class_in.get(owner, set()) if owner else declared_in.get(name, set())
            pairs += bool(homes)
            if homes and source.with_suffix(".h") not in homes:
                wrong.append(f"{house.name(sorted(homes)[0])} declares {name}, but {house.name(source)} defines it.")
    if pairs < 100:
        raise SystemExit(f"FAILED: only {pairs} functions with a declaration were found: this check sees nothing.")
    house.end(wrong, len(headers) + len(sources))


main()
