#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes scipy_weights.txt: what scipy's RBFInterpolator(kernel='cubic', degree=1) solves for on random
constraints, for TestImplicitFunction.cxx, which makes the same constraints by the same generator.
Any scipy from 1.7 on; lines `count smoothing`, then `index weight` for every stride-th weight, then the
polynomial about the origin in four numbers."""
import numpy as np
from scipy.interpolate import RBFInterpolator


def generator(seed):
    state = seed
    while True:
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield (state >> 11) / 2**53


def constraints(count):
    draw = generator(count)
    rows = [[next(draw) for _ in range(4)] for _ in range(count)]
    # Far from the origin and not to scale, as scanner coordinates are.
    points = np.array([[100 * r[0] - 250, 60 * r[1] + 40, 30 * r[2] + 900] for r in rows])
    return points, np.array([2 * r[3] - 1 for r in rows])


with open("scipy_weights.txt", "w") as out:
    for count, smoothing, stride in ((500, 0, 5), (1500, 0, 30), (3000, 0, 60), (500, 20.0, 10)):
        points, values = constraints(count)
        fit = RBFInterpolator(points, values, kernel="cubic", degree=1, smoothing=smoothing)
        weights = fit._coeffs[:count, 0]
        # scipy's polynomial is in shifted and scaled coordinates.
        slope = fit._coeffs[count + 1:, 0] / fit._scale
        constant = fit._coeffs[count, 0] - slope @ fit._shift
        out.write(f"{count} {float(smoothing)!r} {len(range(0, count, stride))}\n")
        for i in range(0, count, stride):
            out.write(f"{i} {float(weights[i])!r}\n")
        out.write(" ".join(repr(float(x)) for x in (constant, *slope)) + "\n")
