# SPDX-License-Identifier: GPL-3.0-or-later
"""The C++ sources are written as clang-format 14 (Debian 12's) writes them; other versions differ in details."""
import subprocess

import house

program = house.tool("clang-format")
version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
if " version 14." not in version:
    house.skip(f"the layout is that of clang-format 14, and this is '{version}'.")
house.run(program, "--dry-run", "-Werror", *map(str, house.files(".h", ".cxx")))
