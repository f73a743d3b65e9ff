# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line writes is whole, or what was there before is: on a full disk, beside another writer, after a kill."""
import contextlib
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import contourtesting as ct

COMMAND = os.path.join(ct.SOURCE, "Plugin", "commandline")
SCRIPT = os.path.join(COMMAND, "reconstruct.py")
PYTHON = shutil.which("python3")
FORMATS = (".vtp", ".stl", ".ply", ".brep", ".csv")
SMALL, LARGE = ct.own("branching_pipe.cnt"), ct.own("brain.cnt")
FOLDER = tempfile.mkdtemp(prefix="whole files ")
sys.path.insert(0, COMMAND)
from contourreplaced import replaced  # noqa: E402


def content(path):
    with open(path, "rb") as file:
        return file.read()


def version(path):
    """What tells the two versions apart, and neither from itself; .vtp has the seconds that each stage took in it."""
    read = content(path)
    if not path.endswith(".vtp"):
        return read
    ct.check(read.rstrip().endswith(b"</VTKFile>"), f"{path} has its end")
    return re.findall(rb'NumberOf\w+="\d+"', read)


@contextlib.contextmanager
def small_disk():
    """A file system of 16 kB; nothing where this user may not make one."""
    where = os.path.join(FOLDER, "disk")
    os.mkdir(where)
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "none", where], capture_output=True, text=True, check=False)
    try:
        yield where if made.returncode == 0 else None
    finally:
        if made.returncode == 0:
            subprocess.run(["umount", where], check=True)
        os.rmdir(where)


def start(source, target, **more):
    return subprocess.Popen([PYTHON, SCRIPT, source, target, "--certificate", "none"], cwd=FOLDER, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, **more)


whole = {}
for extension in FORMATS:
    path = os.path.join(FOLDER, "file" + extension)
    for source in (SMALL, LARGE):
        run = start(source, path)
        ct.check(run.wait() == 0, f"{extension} is written: {run.stderr.read()}")
        whole.setdefault(extension, []).append(version(path))
    # Two at once, of which one is the last.
    runs = [start(source, path) for source in (SMALL, LARGE)]
    ct.check([run.wait() for run in runs] == [0, 0], f"{extension}: two at once: {[run.stderr.read() for run in runs]}")
    ct.check(version(path) in whole[extension], f"{extension}: one of the two is there, whole")
ct.check(sorted(os.listdir(FOLDER)) == sorted("file" + extension for extension in FORMATS), f"no part is left: {os.listdir(FOLDER)}")

with small_disk() as disk:
    if disk is None:
        print("SKIPPED: this user may not mount a small file system, so that no disk was full.")
    for extension in FORMATS if disk else ():
        path = os.path.join(disk, "file" + extension)
        with open(path, "w", encoding="ascii") as file:
            file.write("what was there")
        run = start(LARGE, path)
        _, said = run.communicate()
        ct.check(run.returncode == 1, f"{extension} on a full disk is a failure: {run.returncode}")
        ct.check("written" in said or "disk" in said, f"{extension}: the sentence says so: {said}")
        ct.check(content(path) == b"what was there", f"{extension}: what was there is there")
        ct.check(os.listdir(disk) == ["file" + extension], f"{extension}: no part is left: {os.listdir(disk)}")
        os.remove(path)

# Killed in the midst of it: 100 times, of which some meet the write.
path = os.path.join(FOLDER, "killed")
versions = [bytes([byte]) * 2000000 for byte in (1, 2)]
with open(path, "wb") as file:
    file.write(versions[0])
chance = random.Random(1)
for _ in range(100):
    child = os.fork()
    if child == 0:
        while True:
            for version in versions:
                with replaced(path) as part, open(part, "wb") as file:
                    file.write(version)
    time.sleep(chance.random() * .01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    ct.check(content(path) in versions, "one of the two is there, whole")
ct.check(any(name.startswith(".killed.") for name in os.listdir(FOLDER)), "a kill met a write")
shutil.rmtree(FOLDER)
ct.finish()
