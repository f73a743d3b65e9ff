# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of Contour Mapping by the number of regions and of points a level; `./run bench` calls it.

The work is done by bench_mapping, whose options it passes on (--check).
"""
import os
import subprocess
import sys

program = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_mapping")
sys.exit(subprocess.call([program] + sys.argv[1:]))
