# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package of this build, without pip: array for array what the nodes make.

    TestPythonPackage.py [PYTHON]

PYTHON is the interpreter that the module was built for; without one there is no module, as nanobind was not found.
TestWheel.py does the same with what strangers install.
"""
import os
import shutil
import sys

import contourtesting as ct
from packagetesting import check_cases, nodes_make, run

if len(sys.argv) < 2:
    ct.skip("the Python package is not built, as nanobind or numpy is missing: pip install nanobind numpy, or on Debian 13 "
            "and later the packages nanobind-dev and python3-numpy, and configure again")

simple = ct.load_plugin()
place = os.path.join(os.environ["CONTOUR_BINARY_DIR"], "Testing", "python-package")
package = os.path.join(place, "contour_reconstruction")
shutil.rmtree(place, ignore_errors=True)
shutil.copytree(os.path.join(ct.SOURCE, "Plugin/python/contour_reconstruction"), package)
done = run("cmake", "--install", os.environ["CONTOUR_BINARY_DIR"], "--component", "Python", "--prefix", place)
ct.check(done.returncode == 0, f"the module goes into the package: {done.stderr[-400:]}")
# Without the data of others, which TestWheel.py takes, too.
check_cases(sys.argv[1], "wheelcases.py", os.path.join(place, "cases.npz"), nodes_make(simple, place), 100, shared=place,
            PYTHONPATH=place)
ct.finish()
