# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the fair surface on one thread and on two, and whether both give the same bytes.

    ./run bench fair [--all] [--threads N[,N...]] [--repeat N] [--roi TEXT] [--most N] [--stages] [FILE ...]

Files are structure sets and contour files; without any, those whose times are promised: the heart and the left lung of
dicompyler_rtss.dcm, three runs each; --all: every set of parallel contours of the shared test data, one run. A row an ROI; bench_fair, which
does the work, says what the columns are.
"""
import glob
import os
import subprocess
import sys

SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(os.environ.get("CONTOUR_SOURCE_DIR", "."), "..", "shared", "data"))
PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "ibsi/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour")
PROGRAM = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_fair")
TAKE_A_VALUE = ("--threads", "--repeat", "--roi", "--most")


def main():
    words = [word for word in sys.argv[1:] if word != "--all"]
    files = [word for before, word in zip([""] + words, words) if not word.startswith("--") and before not in TAKE_A_VALUE]
    options = [word for word in words if word not in files]
    if not files and not os.path.isdir(SHARED):
        print(f"fair: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.")
        return 0
    if files or "--all" in sys.argv:
        files = files or [path for pattern in PATTERNS for path in sorted(glob.glob(os.path.join(SHARED, pattern)))]
        return subprocess.call([PROGRAM, *options, *files])
    path = os.path.join(SHARED, "rtstruct", "dicompyler_rtss.dcm")
    return max(subprocess.call([PROGRAM, "--repeat", "3", *options, "--roi", roi, path]) for roi in ("Heart", "Lt Lung"))


sys.exit(main())
