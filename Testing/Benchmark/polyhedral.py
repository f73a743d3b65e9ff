# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the polyhedral method by stage beside CGAL's 3D Delaunay triangulation; `./run bench` calls it.

The work is done by bench_psm, whose options it passes on (--json FILE, --repeat N, --only TEXT).
"""
import os
import subprocess
import sys

program = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_psm")
sys.exit(subprocess.call([program] + sys.argv[1:]))
