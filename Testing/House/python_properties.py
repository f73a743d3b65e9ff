# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package's functions have the nodes' properties, with the names, defaults, choices and ranges of the XML.

Nothing is built or imported for it: the package's files are read as text.
"""
import ast
import math
import xml.etree.ElementTree as tree

import house

PACKAGE = house.root() / "Plugin/python/contour_reconstruction"
#: Function -> the nodes that it is.
NODES = {
    "contour_hierarchy": ["ContourHierarchy"], "contour_mapping": ["ContourMapping"],
    "polyhedral_surface": ["PolyhedralSurface"], "fair_surface": ["FairSurface"], "implicit_surface": ["ImplicitSurface"],
    "contours_on_planes": ["ImplicitConstraints", "ImplicitFunction", "ImplicitContours"],
    "certificate": ["SurfaceCertificate"], "write_structure_set": ["DICOMRTStructureSetWriter"],
    "read_slice_planes": ["DICOMSlicePlanes"],
}
#: What is an argument in Python; inputs are, too, and what a node only tells is in the result.
ARGUMENTS = {"FileName"}
#: (function, property) -> a range of its own.
OWN_RANGES = {("contour_mapping", "OverlapThreshold"): (0, 1), ("fair_surface", "Tolerance"): (-1, math.inf)}
wrong = []


def proxies():
    """Every proxy of the XML by its name; one that has a base comes with the base's properties."""
    found = {}
    for path in sorted((house.root() / "Plugin").glob("*.xml")):
        for proxy in tree.parse(path).getroot().iter():
            if proxy.tag in ("SourceProxy", "WriterProxy"):
                found[proxy.get("name")] = proxy
    return found


def properties(proxy, everyone):
    base = proxy.get("base_proxyname")
    result = properties(everyone[base], everyone) if base else {}
    for entry in proxy:
        if entry.tag.endswith("VectorProperty") and not entry.get("information_only"):
            result[entry.get("name")] = entry
    return {name: entry for name, entry in result.items() if name not in ARGUMENTS}


def constant(name):
    """A dictionary or set of _properties.py."""
    text = (PACKAGE / "_properties.py").read_text(encoding="utf-8")
    for statement in ast.parse(text).body:
        target = getattr(statement, "target", None) or getattr(statement, "targets", [None])[0]
        if isinstance(target, ast.Name) and target.id == name:
            code = compile(ast.Expression(statement.value), "_properties.py", "eval")
            return eval(code, {"math": math, "frozenset": frozenset})
    raise SystemExit(f"FAILED: _properties.py has no {name}.")


def functions():
    """Keyword arguments and their defaults by function."""
    found = {}
    for file in ("_methods.py", "_files.py"):
        for statement in ast.parse((PACKAGE / file).read_text(encoding="utf-8")).body:
            if isinstance(statement, ast.FunctionDef):
                arguments = statement.args
                found[statement.name] = {argument.arg: ast.literal_eval(default) for argument, default in
                                         zip(arguments.kwonlyargs, arguments.kw_defaults)}
    return found


CHOICES, RANGES, FLAGS, TUPLES = (constant(name) for name in ("CHOICES", "RANGES", "FLAGS", "TUPLES"))


def default_of(entry):
    """What the node has, as Python says it."""
    name, text = entry.get("name"), entry.get("default_values", "")
    if name in CHOICES:
        return {number: choice for choice, number in CHOICES[name].items()}[int(text)]
    if name in FLAGS:
        return bool(int(text))
    if entry.tag == "StringVectorProperty":
        return text
    if entry.get("repeat_command"):
        return ()
    numbers = tuple(float(number) for number in text.split())
    return numbers if name in TUPLES else numbers[0]


def check_domain(entry, function):
    name = entry.get("name")
    where = f"{function}, {name}"
    choices = {text.get("text"): int(text.get("value")) for text in entry.iter("Entry")}
    if choices and CHOICES.get(name) != choices:
        wrong.append(f"{where}: the choices are {choices}, and CHOICES has {CHOICES.get(name)}.")
    for domain in entry.findall("DoubleRangeDomain"):
        if name in TUPLES or domain.get("min") is None:
            continue
        limits = (float(domain.get("min")), float(domain.get("max", "inf")))
        own = OWN_RANGES.get((function, name), RANGES.get(name))
        if own != limits:
            wrong.append(f"{where}: the range is {limits}, and RANGES has {own}.")


def check(function, keywords, nodes, everyone):
    wanted = {}
    for node in nodes:
        wanted.update(properties(everyone[node], everyone))
    for name, entry in sorted(wanted.items()):
        where = f"{function}, {name}"
        check_domain(entry, function)
        if name not in keywords:
            wrong.append(f"{where}: the node has it, the function does not.")
        elif keywords[name] != default_of(entry):
            wrong.append(f"{where}: the default is {keywords[name]!r}, that of the node {default_of(entry)!r}.")
    for name in sorted(keywords.keys() - wanted.keys() - {"progress"}):
        wrong.append(f"{function}, {name}: no node has it.")


def main():
    everyone, there = proxies(), functions()
    for function, nodes in NODES.items():
        check(function, there[function], nodes, everyone)
    house.end(wrong, len(NODES))


main()
