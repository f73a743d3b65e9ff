# SPDX-License-Identifier: GPL-3.0-or-later
"""Every number that a node takes, of every node, set to what no panel would: as states, traces and scripts can.

Each ends in one sentence or in a result of finite numbers; never in a crash, a hang, or memory without end. Without an argument
each node is tried in a process of its own, so that it is known which one ended; with a node's name it alone.
"""
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

import contourtesting as ct

REALS = (math.nan, math.inf, -math.inf, -1.0, 0.0, 1e-300, 1e300, -1e300, 1e-9)
WHOLES = (0, -1, 2**31 - 1, -2**31, 1000000)
PVPYTHON = shutil.which("pvpython")
LONGEST = 2400     # seconds a node
COARSE = 2
MEMORY = 8 << 30   # bytes of address space: what asks for more has no bound
# What is no choice of a user: ParaView's own, or the number of values that follow.
NOT_TRIED = {"Report"}


def nodes():
    """(group, name) of every source, filter and writer of the plugin."""
    for file in sorted(os.listdir(os.path.join(ct.SOURCE, "Plugin"))):
        if file.endswith(".xml"):
            for group in ET.parse(os.path.join(ct.SOURCE, "Plugin", file)).getroot().iter("ProxyGroup"):
                if group.get("name") in ("sources", "filters", "writers", "internal_writers"):
                    for element in group:
                        if element.tag.endswith("Proxy"):
                            yield group.get("name"), element.get("name")


def parent():
    tried = 0
    for group, name in nodes():
        try:
            run = subprocess.run([PVPYTHON, "--force-offscreen-rendering", os.path.abspath(__file__), group, name], timeout=LONGEST,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            code, said = run.returncode, run.stdout
        except subprocess.TimeoutExpired as error:
            code, said = "no end", (error.stdout or b"").decode(errors="replace")
        lines = said.strip().splitlines()
        cases = sum(line.startswith("tries ") for line in lines)
        tried += cases
        failed = [line for line in lines if line.startswith("FAILED")]
        last = next((line for line in reversed(lines) if line.startswith("tries ")), "")
        ct.check(code == 0, f"{name} ended with {code} at '{last}': {failed[:5]} {'' if failed else lines[-3:]}")
        print(f"{name}: {cases} cases", flush=True)
    ct.check(tried > 1000, f"only {tried} cases: this looks in the wrong place")
    ct.finish()


def inputs(simple):
    """What each input property is given, by its name and the node's."""
    rings = [[(5 * math.cos(k / 2) - z / 9, 5 * math.sin(k / 2), z) for k in range(12)] for z in (-4.0, -2.0, 0.0, 2.0, 4.0)]

    def source(data):
        made = simple.TrivialProducer()
        made.GetClientSideObject().SetOutput(data)
        return made

    contours = source(ct.closed_polylines(rings))
    constraints = simple.ImplicitConstraints(Input=contours)
    return {"contours": contours, "constraints": constraints, "model": simple.ImplicitFunction(Input=constraints),
            "surface": simple.PolyhedralSurface(Input=contours), "folder": tempfile.mkdtemp(prefix="hostile ")}


class Node:
    def __init__(self, simple, group, name):
        from paraview import servermanager
        self.manager = servermanager.ProxyManager().SMProxyManager
        self.name = name
        self.given = inputs(simple)
        self.proxy = self.manager.NewProxy(group, name)
        self.reset()

    def source_for(self, prop):
        lower = self.name.lower()
        if prop != "Input":
            return self.given["contours"]
        kind = ("constraints" if "function" in lower else "model" if "polygonizer" in lower or "implicitcontours" in lower
                else "surface" if "certificate" in lower or "brep" in lower else "contours")
        return self.given[kind]

    def reset(self):
        self.proxy.ResetPropertiesToDefault()
        for name in self.properties("vtkSMInputProperty"):
            prop = self.proxy.GetProperty(name)
            prop.RemoveAllProxies()
            if name == "Input" or self.name.lower().endswith("certificate"):
                prop.AddInputConnection(self.source_for(name).SMProxy, 0)
        for name in self.properties("vtkSMStringVectorProperty"):
            if name.startswith("FileName"):
                self.proxy.GetProperty(name).SetElement(0, os.path.join(self.given["folder"], "out"))
        self.proxy.UpdateVTKObjects()

    def properties(self, *classes):
        from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator
        each = vtkSMOrderedPropertyIterator()
        each.SetProxy(self.proxy)
        each.Begin()
        names = []
        while not each.IsAtEnd():
            prop = each.GetProperty()
            if prop.GetClassName() in classes and not prop.GetInformationOnly() and not prop.GetIsInternal():
                names.append(each.GetKey())
            each.Next()
        return [name for name in names if name not in NOT_TRIED]

    def run(self):
        self.proxy.UpdateVTKObjects()
        self.proxy.InvokeCommand("Write") if self.proxy.GetXMLGroup().endswith("writers") else self.proxy.UpdatePipeline()

    def finite(self):
        import numpy
        from vtkmodules.util.numpy_support import vtk_to_numpy
        algorithm = self.proxy.GetClientSideObject()
        for port in range(algorithm.GetNumberOfOutputPorts()):
            out = algorithm.GetOutputDataObject(port)
            if out is not None and out.IsA("vtkPointSet") and out.GetPoints():
                if not numpy.isfinite(vtk_to_numpy(out.GetPoints().GetData())).all():
                    return False
        return True

    def tries(self, name, index, value):
        print(f"tries {name}[{index}] = {value}", flush=True)
        self.reset()
        detail = self.proxy.GetProperty("Detail")
        if detail and name not in ("Detail", "CellSize"):
            detail.SetElement(0, COARSE)  # that of a preview, as there are many cases
        prop = self.proxy.GetProperty(name)
        case = f"{self.name}.{name}[{index}] = {value}"

        def act():
            prop.SetElement(index, value)
            self.run()

        said = ct.errors_of(act)
        own = [line for line in said.splitlines() if "(0x" in line and "Algorithm " not in line and "Executive" not in line]
        ct.check(len(own) <= 1, f"{case} says {len(own)} sentences: {said!r}")
        ct.check(all(line.rstrip().endswith(".") for line in own), f"{case} says no sentence: {said!r}")
        ct.check("bad_alloc" not in said, f"{case} takes memory without end: {said!r}")
        ct.check(self.finite(), f"{case} makes points that are not finite")


def child(group, name):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    node = Node(ct.load_plugin(), group, name)
    ct.check(True, "the node can be made")
    for kind, values in (("vtkSMDoubleVectorProperty", REALS), ("vtkSMIntVectorProperty", WHOLES), ("vtkSMIdTypeVectorProperty", WHOLES)):
        for prop in node.properties(kind):
            for index in range(max(1, node.proxy.GetProperty(prop).GetNumberOfElements())):
                for value in values:
                    node.tries(prop, index, value)
    ct.finish()


if len(sys.argv) > 2:
    child(*sys.argv[1:3])
parent()
