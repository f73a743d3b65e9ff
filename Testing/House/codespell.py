# SPDX-License-Identifier: GPL-3.0-or-later
"""Words in sources, help and pages are spelt right; names of things that look like mistakes are in codespell.txt."""
import house

house.run(house.tool("codespell"), "--ignore-words", str(house.beside("codespell.txt")),
          *map(str, house.files(".h", ".cxx", ".py", ".sh", ".cmake", ".txt", ".xml", ".md") + house.pages()))
