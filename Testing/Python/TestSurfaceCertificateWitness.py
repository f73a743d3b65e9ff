# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface Certificate beside an independent witness: metrics.py, which was written apart from this project.

    TestSurfaceCertificateWitness.py [all]

Surfaces are made from the shared data (with `all` from every contour file and closed mesh of it, else from a
few small ones), certified, written as .vtp and measured by metrics.py in a virtual environment of this
test's own (numpy, scipy, vtk, trimesh from PyPI), in which nothing of this project is to be found.

Topology, volume, area and bounds must agree. Pairs of triangles that cross may differ, in cases that are told
apart here by the certificate's own counts: the witness counts an edge that passes through another
triangle's border, which the certificate calls touching, and it counts pairs on points welded by
coordinates. So: where the certificate finds none crossing and none touching, the witness must find none; and every
pair that the certificate calls crossing on the welded surface the witness must find.
"""
import glob
import json
import os
import shutil
import subprocess
import sys

import contourtesting as ct

simple = ct.load_plugin()

SHARED = os.environ["CONTOUR_SHARED_DATA"]
WITNESS = os.path.join(SHARED, "..", "metrics.py")
ALL = "all" in sys.argv[1:]
LARGEST = 300000 if ALL else 30000  # triangles; the witness is not made for more


def make_environment():
    """The python of a virtual environment that has what the witness needs; skips where there can be none."""
    folder = os.path.join(os.environ["CONTOUR_BINARY_DIR"], "Testing", "witness-environment")
    python = os.path.join(folder, "bin", "python")
    stamp = os.path.join(folder, "complete")
    if os.path.exists(stamp):
        return python
    shutil.rmtree(folder, ignore_errors=True)
    host = shutil.which("python3")
    if host is None:
        ct.skip("there is no python3 to make the witness's environment with.")
    steps = [[host, "-m", "venv", folder],
             [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check",
              "numpy", "scipy", "vtk", "trimesh"]]
    for step in steps:
        done = subprocess.run(step, env=clean_environment(), capture_output=True, text=True, timeout=900)
        if done.returncode != 0:
            ct.skip(f"'{' '.join(step)}' failed, so there is no witness: {done.stderr.strip()[-400:]}")
    open(stamp, "w").close()
    return python


def clean_environment():
    """The caller's, without what leads Python to ParaView's modules."""
    return {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_", "VTK"))}


def ask_witness(python, path):
    done = subprocess.run([python, WITNESS, path, "--compact", "--si-max", str(LARGEST)],
                          env=clean_environment(), capture_output=True, text=True, timeout=3000)
    if done.returncode != 0:
        ct.check(False, f"the witness failed on {path}: {done.stderr.strip()[-400:]}")
        return None
    return json.loads(done.stdout.strip().splitlines()[-1])


def certify(proxy_or_data, weld):
    source = proxy_or_data
    if not hasattr(source, "SMProxy"):
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(proxy_or_data)
    return ct.data(simple.SurfaceCertificate(Input=source, Weld=weld))


def total(data, section="Total"):
    text = data.GetFieldData().GetAbstractArray("CertificateJSON").GetValue(0)
    return json.loads(text)[section]


def blocks(data, title):
    if data.IsA("vtkPolyData"):
        return [(title, data)]
    found = []
    for i in range(data.GetNumberOfPartitionedDataSets()):
        part = data.GetPartition(i, 0) if data.GetNumberOfPartitions(i) else None
        if part is not None:
            found.append((f"{title} {i}", part))
    return found


def contour_surfaces():
    """(name, surface) of contour files through the Polyhedral Surface."""
    if ALL:
        files = sorted(glob.glob(os.path.join(SHARED, "cnt", "*.cnt")) +
                       glob.glob(os.path.join(SHARED, "csl", "*.csl")) +
                       glob.glob(os.path.join(SHARED, "rtstruct", "**", "*.dcm"), recursive=True))
    else:
        files = [ct.shared("cnt/manytomany.cnt"), ct.shared("csl/eight_15.csl"), ct.shared("csl/hand_ok.csl"),
                 ct.shared("rtstruct/phantoms/Cone_30_0.dcm")
                 if os.path.exists(os.path.join(SHARED, "rtstruct/phantoms/Cone_30_0.dcm"))
                 else ct.shared("rtstruct/cerr_ibsi.dcm")]
    readers = {".cnt": "NUAGESContourReader", ".csl": "CurveNetworkReader", ".dcm": "DICOMRTStructureSetReader"}
    for path in files:
        reader = getattr(simple, readers[os.path.splitext(path)[1]])(FileName=path)
        reader.UpdatePipeline()
        for name, contours in blocks(ct.data(reader), os.path.basename(path)):
            if not is_parallel(contours):
                continue
            producer = simple.TrivialProducer()
            producer.GetClientSideObject().SetOutput(contours)
            made = ct.data(simple.PolyhedralSurface(Input=producer))
            if made.GetNumberOfCells() > 0:
                yield name, made


def is_parallel(contours):
    """At least two parallel planes, and no others: what the Polyhedral Surface is for."""
    if contours.GetNumberOfCells() == 0:
        return False
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(contours)
    hierarchy = simple.ContourHierarchy(Input=producer)
    # Contours of which none is usable are an error, which is no concern of this test; observed, it is not printed.
    algorithm = hierarchy.GetClientSideObject()
    for speaker in (algorithm, algorithm.GetExecutive()):
        speaker.AddObserver("ErrorEvent", lambda *_: None)
    levels = ct.data(hierarchy).GetFieldData().GetArray("LevelNormal")
    normals = {levels.GetTuple(i) for i in range(levels.GetNumberOfTuples())} if levels else set()
    return len(normals) == 1 and levels.GetNumberOfTuples() > 1


def read_off(path):
    """vtkPolyData of an .off file, which ParaView cannot read."""
    from certificateshapes import surface
    with open(path) as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    if words[0] != "OFF":
        raise ValueError(f"{path} does not begin with OFF")
    count, faces = int(words[1]), int(words[2])
    points = [tuple(float(w) for w in words[4 + 3 * i:7 + 3 * i]) for i in range(count)]
    cells, at = [], 4 + 3 * count
    for _ in range(faces):
        corners = int(words[at])
        cells.append([int(w) for w in words[at + 1:at + 1 + corners]])
        at += 1 + corners
    return surface(points, cells)


def stored_surfaces():
    """(name, surface) of closed meshes that others made."""
    if not ALL:
        yield "eight_15_scaled.stl", ct.data(
            simple.STLReader(FileNames=[ct.shared("csl/reference/eight_15_scaled.stl")]))
        yield "femur.off", read_off(ct.shared("mesh/femur.off"))
        return
    for path in sorted(glob.glob(os.path.join(SHARED, "csl", "reference", "*.stl"))):
        yield os.path.basename(path), ct.data(simple.STLReader(FileNames=[path]))
    for path in sorted(glob.glob(os.path.join(SHARED, "mesh", "*.obj"))):
        yield os.path.basename(path), ct.data(simple.WavefrontOBJReader(FileName=path))
    for path in sorted(glob.glob(os.path.join(SHARED, "mesh", "*.off"))):
        yield os.path.basename(path), read_off(path)


def write(data, name):
    path = ct.output("Witness-" + "".join(c if c.isalnum() else "_" for c in name) + ".vtp")
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()
    writer.SetFileName(path)
    bare = data.NewInstance()
    bare.SetPoints(data.GetPoints())
    bare.SetPolys(data.GetPolys())
    writer.SetInputData(bare)
    writer.Write()
    return path


def close(a, b, relative):
    return abs(a - b) <= relative * max(abs(a), abs(b), 1e-300)


TOPOLOGY = {"points": "Points", "edges": "Edges", "boundary_edges": "OpenEdges", "nonmanifold_edges": "OverusedEdges",
            "nonmanifold_vertices": "PinchedVertices", "duplicate_triangles": "DuplicateTriangles",
            "components": "Components", "euler": "Euler"}


def compare_topology(name, theirs, ours, which):
    for their_name, our_name in TOPOLOGY.items():
        ct.check(theirs[their_name] == ours[our_name],
                 f"{name}, {which}: {our_name} is {ours[our_name]}, the witness says {theirs[their_name]}")
    ct.check(theirs["closed"] == (ours["Closed"] and ours["EdgeManifold"]), f"{name}, {which}: closed differs")
    ct.check(theirs["oriented"] == (ours["Closed"] and ours["EdgeManifold"] and ours["Oriented"]),
             f"{name}, {which}: oriented differs")
    if theirs.get("genus_sum") is not None and ours["Genus"] is not None:
        ct.check(theirs["genus_sum"] == ours["Genus"], f"{name}, {which}: genus differs")


def compare(name, data, python):
    if data.GetNumberOfCells() > LARGEST:
        print(f"{name}: {data.GetNumberOfCells()} triangles are too many for the witness")
        return
    theirs = ask_witness(python, write(data, name))
    if theirs is None:
        return
    as_is, welded = total(certify(data, 0)), total(certify(data, 1))
    compare_topology(name, theirs["topology_as_stored"], as_is, "as stored")
    compare_topology(name, theirs["topology"], welded, "welded")
    ct.check(close(theirs["area"], welded["Area"], 1e-9), f"{name}: area {welded['Area']}, {theirs['area']}")
    if theirs["volume_well_defined"]:
        ct.check(welded["Volume"] is not None and close(theirs["volume"], welded["Volume"], 1e-9),
                 f"{name}: volume {welded['Volume']}, {theirs['volume']}")
    bounds = [[welded[side + axis] for axis in "XYZ"] for side in ("Low", "High")]
    ct.check(theirs["bounds"] == bounds, f"{name}: bounds {bounds}, {theirs['bounds']}")
    pairs = theirs["self_intersections"]
    crossing, touching = welded["CrossingPairs"], welded["TouchingPairs"]
    print(f"{name}: {data.GetNumberOfCells()} triangles, crossing {crossing} (as stored {as_is['CrossingPairs']}), "
          f"touching {touching}, overlapping {welded['OverlappingPairs']}; the witness counts {pairs}")
    # Its pairs are within a tolerance of 1e-12, so of a thousand pairs some may fall on either side.
    slack = crossing // 500
    ct.check(crossing - slack <= pairs <= crossing + touching + slack,
             f"{name}: {pairs} pairs by the witness, {crossing} crossing and {touching} touching here")


if not os.path.exists(WITNESS):
    ct.skip(f"the witness {WITNESS} is not there.")
witness_python = make_environment()
for surfaces in (contour_surfaces(), stored_surfaces()):
    for surface_name, surface_data in surfaces:
        compare(surface_name, surface_data, witness_python)
ct.finish()
