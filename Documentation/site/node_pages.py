# SPDX-License-Identifier: GPL-3.0-or-later
"""A page a node, made of what the plugin's XML tells ParaView: what it is for, inputs, properties, where its source is."""
import pathlib
import re
import xml.etree.ElementTree as ElementTree

# The order of a pipeline; what is none of these comes behind them.
FAMILIES = (("Readers and writers", "Readers.xml"), ("Contours", "Contours.xml"), ("Polyhedral Surface Method", "Polyhedral.xml"),
            ("Implicit Surface Method", "Implicit.xml"), ("Certificate", "Certificate.xml"))
KINDS = {"sources": "source", "filters": "filter", "writers": "writer"}
SOURCES = ("Filters/ContourFilters", "Filters/PolyhedralFilters", "Filters/ImplicitFilters", "Readers/*")


class Property:
    """What a user may set."""

    def __init__(self, element):
        self.name = element.get("name")
        self.element = element
        self.words = plain(element.findtext("Documentation"))
        self.is_input = element.tag == "InputProperty"
        self.is_shown = (element.get("information_only") != "1" and element.get("is_internal") != "1" and
                         element.get("panel_visibility") != "never")

    @property
    def takes(self):
        """Its choices, or its range."""
        entries = [entry.get("text") for entry in self.element.iter("Entry")]
        if entries:
            return ", ".join(entries)
        if self.element.find("BooleanDomain") is not None:
            return "on, off"
        for domain in self.element:
            if domain.tag.endswith("RangeDomain"):
                low, high = domain.get("min"), domain.get("max")
                return f"{low or ''} ... {high or ''}".strip() if low or high else "a number"
        return {"StringVectorProperty": "text", "DoubleVectorProperty": "numbers", "IntVectorProperty": "whole numbers"}.get(
            self.element.tag, "")

    @property
    def default(self):
        value = self.element.get("default_values") or ""
        for entry in self.element.iter("Entry"):
            if entry.get("value") == value:
                return entry.get("text")
        if self.element.find("BooleanDomain") is not None:
            return {"1": "on", "0": "off"}.get(value, value)
        return value


class Node:
    """A node with all of its properties, those of its bases first."""

    def __init__(self, element, group, file, bases):
        self.name = element.get("name")
        self.label = element.get("label") or self.name
        self.kind = KINDS[group]
        self.file = file
        self.vtk_class = element.get("class")
        documentation = element.find("Documentation")
        self.short = documentation.get("short_help")
        self.words = [plain(part) for part in re.split(r"\n\s*\n", "".join(documentation.itertext())) if part.strip()]
        self.ports = [port.get("name") for port in element.iter("OutputPort")]
        self.extensions = sorted({ending for hint in element.iter() if hint.tag in ("ReaderFactory", "WriterFactory")
                                  for ending in hint.get("extensions", "").split()})
        self.properties = {}
        for part in list(bases.get(element.get("base_proxyname"), {}).values()) + [
                Property(part) for part in element if part.tag.endswith("Property")]:
            if part.name:
                self.properties[part.name] = part


def plain(text):
    return " ".join((text or "").split())


def cell(text):
    return text.replace("|", "\\|") or " "


def read_bases(path):
    """Properties of the parts that nodes take over, by the part's name."""
    bases = {}
    for element in ElementTree.parse(path).getroot().iter("SourceProxy"):
        own = {part.get("name"): Property(part) for part in element if part.tag.endswith("Property") and part.get("name")}
        bases[element.get("name")] = {**bases.get(element.get("base_proxyname"), {}), **own}
    return bases


def read_nodes(root):
    """All nodes, in the order of their families' files."""
    bases = read_bases(root / "Plugin" / "Bases.xml")
    nodes = []
    for _, file in FAMILIES:
        for group in ElementTree.parse(root / "Plugin" / file).getroot().iter("ProxyGroup"):
            for element in group:
                if group.get("name") in KINDS and element.tag in ("SourceProxy", "WriterProxy", "PSWriterProxy"):
                    nodes.append(Node(element, group.get("name"), file, bases))
    return nodes


def source_of(root, vtk_class):
    """The path of the header of a class, or nothing where ParaView or VTK brings it."""
    for folder in SOURCES:
        for path in root.glob(f"{folder}/{vtk_class}.h"):
            return path.relative_to(root).as_posix()
    return None


def table(titles, rows):
    return "\n".join(["| " + " | ".join(titles) + " |", "|" + "---|" * len(titles)] +
                     ["| " + " | ".join(cell(str(word)) for word in row) + " |" for row in rows])


def example(node, inputs):
    """The line that makes it in pvpython."""
    given = [f"{part.name}={part.name[0].lower() + part.name[1:]}" for part in inputs
             if part.element.find("Hints/Optional") is None and part.element.get("null_on_empty") != "1"]
    if "FileName" in node.properties and node.kind == "source":
        given.append(f'FileName="file.{(node.extensions or ["dcm"])[0]}"')
    if "FileNames" in node.properties:
        given.append(f'FileNames=["slice1.{node.extensions[0]}", "slice2.{node.extensions[0]}"]')
    if node.kind == "writer":
        return f'SaveData("file.{node.extensions[0]}", input)' if node.extensions else ""
    return f"node = {node.name}({', '.join(given)})"


def page(root, node):
    """The page of a node as Markdown."""
    inputs = [part for part in node.properties.values() if part.is_input]
    settings = [part for part in node.properties.values() if part.is_shown and not part.is_input and part.words]
    parts = [f"# {node.label}", f"*{node.short}*"]
    picture = root / "Documentation" / "pictures" / "nodes" / f"{node.name}.png"
    if picture.exists():
        parts.append(f"![{node.label}](../pictures/nodes/{node.name}.png)")
    parts += node.words
    if node.extensions:
        parts.append("Files: " + ", ".join(f"`.{ending}`" for ending in node.extensions) + ".")
    if inputs:
        parts += ["## Inputs", table(["input", "what"], [[part.name, part.words] for part in inputs])]
    if node.ports:
        parts += ["## Outputs", "\n".join(f"{number}. {name}" for number, name in enumerate(node.ports))]
    if settings:
        parts += ["## Properties", table(["property", "default", "takes", "what"],
                                         [[f"`{part.name}`", part.default, part.takes, part.words] for part in settings])]
    line = example(node, inputs)
    if line:
        parts += ["## In Python", f"```\n{line}\n```"]
    header = source_of(root, node.vtk_class)
    parts += ["## Source", f"Class `{node.vtk_class}`" + (f", `{header}`" if header else "") + f"; described in `Plugin/{node.file}`."]
    return "\n\n".join(parts) + "\n"


def write_pages(root, folder):
    """A page a node, and the list of them; returns the nodes."""
    folder.mkdir(parents=True, exist_ok=True)
    nodes = read_nodes(root)
    for node in nodes:
        (folder / f"{node.name}.md").write_text(page(root, node), encoding="utf-8")
    parts = ["# All nodes, one by one"]
    for title, file in FAMILIES:
        own = [node for node in nodes if node.file == file]
        parts += [f"## {title}", table(["node", "what"], [[f"[{node.label}]({node.name}.md)", node.short] for node in own]),
                  "```{toctree}\n:hidden:\n\n" + "\n".join(node.name for node in own) + "\n```"]
    (folder / "index.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")
    return nodes


if __name__ == "__main__":
    import sys
    print(len(write_pages(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))), "pages")
