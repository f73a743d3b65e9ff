# SPDX-License-Identifier: GPL-3.0-or-later
"""Thirty structure sets of others in one call, one of them damaged: the others are done, and it is named."""
import glob
import json
import os
import shutil
import subprocess

import contourtesting as ct

SCRIPT = os.path.join(ct.SOURCE, "Plugin", "commandline", "reconstruct.py")
FOLDER = ct.output("cohort of others")
sources = sorted(glob.glob(os.path.join(os.path.dirname(ct.shared("ibsi/STS_001_CT.dcm")), "*.dcm")))
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(os.path.join(FOLDER, "surfaces"))
ct.check(len(sources) == 30, f"there are {len(sources)} sets")
for path in sources:
    shutil.copy(path, FOLDER)
damaged = os.path.join(FOLDER, os.path.basename(sources[13]))
with open(damaged, "rb+") as file:
    file.truncate(os.path.getsize(damaged) * 2 // 3)
run = subprocess.run([shutil.which("python3"), SCRIPT, "*.dcm", "surfaces/{}.stl", "--jobs", "2", "--summary", "cohort.json"],
                     cwd=FOLDER, capture_output=True, text=True)
ct.check(run.returncode == 1, f"it returns {run.returncode}")
said = [line for line in run.stderr.splitlines() if line.startswith("contour-reconstruct: ")]
ct.check(len(said) == 1 and os.path.basename(damaged) in said[0], f"the damaged one is named: {said}")
ct.check("29 of 30 files done, 0 with nothing to do, 1 failed, 0 not tried." in run.stdout, run.stdout[-400:])
ct.check(len(os.listdir(os.path.join(FOLDER, "surfaces"))) == 29, "29 surfaces are written")
with open(os.path.join(FOLDER, "cohort.json"), encoding="utf-8") as file:
    told = json.load(file, parse_constant=lambda word: ct.check(False, f"the summary holds {word}"))
ct.check((told["Files"], told["Done"], told["Failed"]) == (30, 29, 1), "the summary counts")
regions = [region for outcome in told["Outcomes"] for region in outcome["Regions"]]
ct.check(len(regions) == 29 and all(region["Closed"] and region["Manifold"] and region["CrossingPairs"] == 0 and
                                    region["Unit"] == "mm" for region in regions), "29 surfaces are sound")
print(run.stdout[-200:], said)
ct.finish()
