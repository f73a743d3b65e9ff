# SPDX-License-Identifier: GPL-3.0-or-later
"""Headers are included by their public folder ("Contours/ContourSet.h"), never by a way up ("../Contours/...")."""
import re

import house

sources = house.files(".h", ".cxx")
wrong = [f"{house.name(path)}:{number}: {line}" for path in sources
         for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
         if re.match(r"#\s*include\s*[<\"].*\.\./", line)]
house.end(wrong, len(sources))
