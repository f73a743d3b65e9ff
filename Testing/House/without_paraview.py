# SPDX-License-Identifier: GPL-3.0-or-later
"""-DCONTOUR_PLUGIN=OFF configures, with all its tests, where ParaView and VTK cannot be found, and asks for neither.

Slow.WithoutParaView builds it and runs the tests as well.
"""
import subprocess
import sys
import tempfile

import house

with tempfile.TemporaryDirectory() as folder:
    done = subprocess.run(
        ["cmake", "-G", "Ninja", "-S", str(house.root()), "-B", folder, "-DCONTOUR_PLUGIN=OFF",
         "-DCMAKE_DISABLE_FIND_PACKAGE_ParaView=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    # CMake says of a variable that nothing asked for it.
    asked = [name for name in ("ParaView", "VTK") if f"    CMAKE_DISABLE_FIND_PACKAGE_{name}\n" not in done.stdout]
if done.returncode or asked:
    print(done.stdout)
    sys.exit(f"FAILED: it does not configure, or looks for {' and '.join(asked) or 'nothing'}.")
print("It configures, and nobody looks for ParaView or VTK.")
