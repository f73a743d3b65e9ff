# SPDX-License-Identifier: GPL-3.0-or-later
"""Every header of the core has a test of its name: a file TestNAME.cxx, or cases TEST(NAME, ...) beside others.

Where that would say nothing, units_tested.txt has the sentence why not.
"""
import re

import house

headers = house.files(".h", folders=("Filters/Core",))
tests = house.files(".cxx", folders=("Testing",))
names = {path.stem[len("Test"):] for path in tests if path.stem.startswith("Test")}
for path in tests:
    names.update(re.findall(r"^TEST(?:_F|_P)?\((\w+),", path.read_text(encoding="utf-8"), flags=re.MULTILINE))
reasons = dict(line.split(": ", 1) for line in house.exceptions("units_tested.txt"))

units = {path.relative_to(house.root() / "Filters/Core").with_suffix("").as_posix(): path.stem for path in headers}
wrong = [f"Filters/Core/{unit}.h has no test of its name, nor a reason in units_tested.txt."
         for unit, name in units.items() if name not in names and unit not in reasons]
for unit in sorted(reasons):
    if units.get(unit) in names or unit not in units:
        print(f"units_tested.txt: {unit} {'has a test now' if unit in units else 'is not there any more'}: take it out.")
house.end(wrong, len(headers))
