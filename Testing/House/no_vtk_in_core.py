# SPDX-License-Identifier: GPL-3.0-or-later
"""The core and the parsers stay usable without VTK: none of their files includes a header of it.

Readers/*/vtk*.h and .cxx are the VTK layer over the parsers; nothing of the parsers may include these either.
"""
import re

import house

sources = [path for path in house.files(".h", ".cxx", folders=("Filters/Core", "Readers"))
           if not path.name.startswith("vtk")]
wrong = [f"{house.name(path)}: {line}" for path in sources for line in path.read_text(encoding="utf-8").splitlines()
         if re.match(r"#\s*include\s*[<\"](.*/)?vtk", line)]
house.end(wrong, len(sources))
