# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours smaller than a pixel that nobody drew are left out of a structure set; those that somebody drew stay."""
import os
import sys

import contourtesting as ct

sys.path.insert(0, os.path.join(ct.SOURCE, "Plugin", "commandline"))
import contourcli as cli
from vtkmodules.vtkCommonCore import vtkIntArray

ct.load_plugin()


def squares(sides):
    """A square of each side, in a tilted plane, numbered."""
    data = ct.closed_polylines([[(x * side, 10.0 * k + 0.6 * y * side, 5.0 + 0.8 * y * side)
                                 for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))] for k, side in enumerate(sides)])
    numbers = vtkIntArray()
    numbers.SetName("Number")
    for k in range(len(sides)):
        numbers.InsertNextValue(k)
    data.GetCellData().AddArray(numbers)
    return data


ct.check(all(abs(got - side ** 2) < 1e-12 for got, side in zip(cli.areas(squares([1, 0.5, 3])), [1, 0.5, 3])), "areas")
# What was drawn, a pixel's area, and which of the squares of side 2, 0.5, 0.1 and 3 stay.
for drawn, pixel, expected in [([3], 1.0, [0, 3]), ([0.6, 3], 1.0, [0, 1, 3]), ([3], 0.0, [0, 1, 2, 3]),
                               ([], 1.0, [0, 3]), ([3], 1e-4, [0, 1, 2, 3])]:
    kept, left_out = cli.without_specks(squares([2, 0.5, 0.1, 3]), squares(drawn), pixel)
    numbers = kept.GetCellData().GetArray("Number")
    got = [numbers.GetValue(i) for i in range(kept.GetNumberOfCells())]
    ct.check(got == expected, f"drawn {drawn}, pixel {pixel}: {got} instead of {expected}")
    ct.check(left_out == 4 - len(expected), f"drawn {drawn}, pixel {pixel}: {left_out} left out")
ct.finish()
