# SPDX-License-Identifier: GPL-3.0-or-later
"""Many files in one call: what is done, what is said of those that are not, and that neither help nor Ctrl-C needs a stack."""
import argparse
import importlib
import json
import os
import pty
import re
import shutil
import signal
import subprocess
import sys
import time

import contourtesting as ct

COMMANDS = os.path.join(ct.SOURCE, "Plugin", "commandline")
SCRIPT = os.path.join(COMMANDS, "reconstruct.py")
FOLDER = ct.output("cohort")
PYTHON = shutil.which("python3")
sys.path.insert(0, COMMANDS)


def call(*arguments, **more):
    return subprocess.run([PYTHON, SCRIPT, *arguments], cwd=FOLDER, capture_output=True, text=True, **more)


def make(path, z=(0, 1, 2, 3), x=0.0, end="}"):
    """A prism in a file, whole unless it is to end otherwise."""
    full = os.path.join(FOLDER, path)
    os.makedirs(os.path.dirname(full), exist_ok=True)
    sections = [f"v 4 z {h}\n{{\n{x} 0\n{x + 1} 0\n{x + 1} 1\n{x} 1\n" for h in z]
    with open(full, "w", encoding="ascii") as file:
        file.write(f"S {len(z)}\n" + "}\n".join(sections) + end + "\n")
    return full


def strictly(path):
    """JSON without the words that only some programs know."""
    def refuse(word):
        ct.check(False, f"{path} holds {word}")
    with open(os.path.join(FOLDER, path), encoding="utf-8") as file:
        return json.load(file, parse_constant=refuse)


def read(path):
    with open(os.path.join(FOLDER, path), "rb") as file:
        return file.read()


shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(os.path.join(FOLDER, "out"))
for patient in ("anna", "bert", "carl"):
    make(f"{patient}/set.cnt", x=len(patient))
make("dora/broken.cnt", end="")
make("emil/one.cnt", z=range(9))

run = call("*/set.cnt", "anna/set.cnt", "dora/broken.cnt", "emil/*.cnt", "nobody/*.cnt", "out/{}.stl", "--jobs", "2",
           "--summary", "out/cohort.json", "--certificate", "out/figures.json", "--unit", "mm")
ct.check(run.returncode == 1, f"a cohort with a damaged file returns 1: {run.returncode} {run.stderr}")
ended = [line for line in run.stderr.splitlines() if line.startswith("contour-reconstruct: ")]
ct.check(len(ended) == 2 and "dora/broken.cnt, line" in ended[0] and "no file nobody/*.cnt" in ended[1],
         f"those that failed are named at the end: {run.stderr}")
ct.check("4 of 6 files done, 0 with nothing to do, 2 failed, 0 not tried." in run.stdout, run.stdout)
ct.check(sorted(name for name in os.listdir(os.path.join(FOLDER, "out")) if name.endswith(".stl")) ==
         ["anna-set.stl", "bert-set.stl", "carl-set.stl", "one.stl"], f"a surface each: {os.listdir(FOLDER + '/out')}")
rows = [line.split() for line in run.stdout.splitlines() if "set.cnt" in line and "done" in line]
ct.check(len(rows) == 3 and all(row[5:7] == ["yes", "yes"] and row[9] == "cm3" for row in rows),
         f"a row a region, with the volume in cm3: {rows}")
told = strictly("out/cohort.json")
ct.check((told["Files"], told["Done"], told["Failed"]) == (6, 4, 2), f"the summary counts: {told}")
ct.check([os.path.basename(outcome["File"]) for outcome in told["Outcomes"]] ==
         ["set.cnt"] * 3 + ["broken.cnt", "one.cnt", "*.cnt"], "outcomes stand in the order of the files")
first = told["Outcomes"][0]["Regions"][0]
ct.check(first["Closed"] is True and first["Manifold"] is True and abs(first["Volume"] - 3) < 0.7 and
         first["Output"] == "out/anna-set.stl" and first["Unit"] == "mm", f"a region is told of: {first}")
ct.check(set(strictly("out/figures.json")) == {"anna/set.cnt", "bert/set.cnt", "carl/set.cnt", "emil/one.cnt"},
         "certificates go by file")

# One process or two, the surfaces are the same; without {} the file's name goes before the extension.
again = call("*/set.cnt", "again.stl")
ct.check(again.returncode == 0, f"a cohort without damage returns 0: {again.stderr}")
ct.check(read("again-carl-set.stl") == read("out/carl-set.stl"), "as many bytes by one process as by two")
# What is wrong for all is said once, before or at the first.
for words, arguments in (("one of Flat", ["*/set.cnt", "out/{}.stl", "--set", "EndCaps=Round"]),
                         ("no folder", ["*/set.cnt", "nowhere/{}.stl"]), ("cannot write", ["*/set.cnt", "{}.obj"]),
                         ("no folder", ["*/set.cnt", "{}.stl", "--summary", "nowhere/cohort.json"])):
    run = call(*arguments)
    said = [line for line in run.stderr.splitlines() if line.startswith("contour-reconstruct: ")]
    ct.check(run.returncode == 1 and len(said) == 1 and words in said[0], f"{arguments}: {run.stderr}")
# Two files to one name are told of.
make("f/a.cnt")
contourcohort = importlib.import_module("contourcohort")
contouroptions = importlib.import_module("contouroptions")


def fake(text):
    """A process that reads a task and does as the text says."""
    path = ct.output("fake_worker.py")
    with open(path, "w", encoding="ascii") as file:
        file.write("import json, os, signal, sys\nfor line in sys.stdin:\n    task = json.loads(line)\n" + text)
    return [PYTHON, path]


def cohort(text, *arguments):
    here = os.getcwd()
    os.chdir(FOLDER)
    try:
        options = contouroptions.parse(list(arguments))
        made = contourcohort.Cohort(options, list(arguments), fake(text))
        return made.run()
    finally:
        os.chdir(here)


# A process that is killed costs the file that it was at.
ends = cohort("""    if "bert" in task["Input"]:
        os.kill(os.getpid(), signal.SIGKILL)
    print(json.dumps({"File": task["Input"], "Status": "done", "Error": None, "Notes": [],
                      "Regions": [{"Name": "r", "Status": "done", "Output": "same.stl"}]}), flush=True)
""", "*/set.cnt", "{}.stl")
ct.check([end["Status"] for end in ends] == ["done", "failed", "failed"], f"outcomes are {ends}")
ct.check("SIGKILL" in ends[1]["Error"] and "bert" in ends[1]["Error"], f"the one is named: {ends[1]}")
ct.check("same.stl is what anna/set.cnt is written to" in ends[2]["Error"], f"a name for two: {ends[2]}")

# Ctrl-C: what was done is told, and no stack.
made = subprocess.Popen([PYTHON, SCRIPT, ct.own("head.cnt"), ct.own("brain.cnt"), "anna/set.cnt", "late-{}.stl", "--method", "ism"],
                        cwd=FOLDER, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
time.sleep(4)
made.send_signal(signal.SIGINT)
out, err = made.communicate(timeout=60)
# On a slow machine MPI may still be starting below ParaView, and then its own daemon has a word.
err = "\n".join(line for line in err.splitlines() if "ORTE_ERROR_LOG" not in line)
ct.check(made.returncode == 130 and err.splitlines()[-1] == "contour-reconstruct: stopped." and "Traceback" not in err and
         "Stack" not in err, f"Ctrl-C: {made.returncode} {err}")
ct.check("not tried." in out, f"what was done is told: {out}")
made = subprocess.Popen([PYTHON, SCRIPT, ct.own("head.cnt"), "late.stl", "--method", "ism"], cwd=FOLDER,
                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
time.sleep(4)
made.send_signal(signal.SIGINT)
out, err = made.communicate(timeout=60)
ct.check(made.returncode == -signal.SIGINT and err == "", f"Ctrl-C of one file: {made.returncode} {err}")
ct.check(not [name for name in os.listdir(FOLDER) if "part" in name or "late" in name], "no half file is left")

# Help and the manual page need no ParaView, and tell of every option.
words = call("--help", env={**os.environ, "CONTOUR_PVPYTHON": "/nowhere/pvpython"}).stdout
page = subprocess.run([PYTHON, os.path.join(COMMANDS, "manpage.py"), "1.2.3"], capture_output=True, text=True).stdout
for action in contouroptions.make_parser()._actions:
    for name in action.option_strings:
        ct.check(name in words, f"--help tells of {name}")
        ct.check("\\fB" + name.replace("-", "\\-") in page, f"the manual page tells of {name}")
ct.check("Contour Reconstruction 1.2.3" in page and ".SH EXIT STATUS" in page, "the manual page is whole")
ct.check(isinstance(contouroptions.make_parser(), argparse.ArgumentParser) and "paraview" not in words, "help is plain")
if shutil.which("groff"):
    judged = subprocess.run(["groff", "-man", "-ww", "-Tutf8"], input=page, capture_output=True, text=True)
    ct.check(judged.stderr == "" and "SEVERAL FILES" in re.sub(r"\x1b\[\d*m|.\x08", "", judged.stdout), f"groff: {judged.stderr}")

# Completion in bash: options, their choices, and files that can be read.
made = subprocess.run([PYTHON, os.path.join(COMMANDS, "completion.py")], capture_output=True, text=True)
for words, last, wanted, unwanted in ((["--me"], 1, "--method", "--roi"), (["--method", "p"], 2, "psm", "fair"),
                                      ([os.path.join(os.path.dirname(ct.own("head.cnt")), "")], 1, "head.cnt", "CERTIFICATES.md")):
    line = f"COMP_WORDS=(contour-reconstruct {' '.join(words)}); COMP_CWORD={last}; compopt() {{ :; }}; _contour_reconstruct; "
    shown = subprocess.run(["bash", "-O", "extglob", "-c", made.stdout + line + 'printf "%s\\n" "${COMPREPLY[@]}"'],
                           capture_output=True, text=True)
    ct.check(wanted in shown.stdout and unwanted not in shown.stdout and not shown.stderr,
             f"completion of {words}: {shown.stdout} {shown.stderr}")

# Colours are for terminals, and for those who want them.
for variables, coloured in (({}, True), ({"NO_COLOR": "1"}, False)):
    master, slave = pty.openpty()
    done = subprocess.Popen([PYTHON, SCRIPT, "anna/set.cnt", "colour.stl"], cwd=FOLDER, stdout=slave, stderr=subprocess.DEVNULL,
                            env={**os.environ, "TERM": "xterm", **variables})
    os.close(slave)
    shown = b""
    while True:
        try:
            piece = os.read(master, 4096)
        except OSError:
            break
        if not piece:
            break
        shown += piece
    done.wait()
    ct.check((b"\x1b[32m" in shown) == coloured, f"colours with {variables}: {shown[:200]}")
ct.finish()
