# SPDX-License-Identifier: GPL-3.0-or-later
"""How many points the triangulations of levels need beside those of the contours, of every set there is.

    ./run bench levels [FILE ...]

A row an ROI or set of parallel contours; bench_levels, which does the work, says what the columns are.
"""
import glob
import os
import subprocess
import sys

SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(os.environ.get("CONTOUR_SOURCE_DIR", "."), "..", "shared", "data"))
PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "ibsi/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour")

files = sys.argv[1:] or [path for pattern in PATTERNS for path in sorted(glob.glob(os.path.join(SHARED, pattern)))]
if not files:
    print(f"levels: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.")
else:
    print("file\tROI\tlevels\tpoints a contour point, at most\tof levels of 50 or more\tlevels without condition 2", flush=True)
    sys.exit(subprocess.call([os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_levels"), *files]))
