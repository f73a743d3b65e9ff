#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's small examples (its chapter 10), rebuilt by formula.

    python3 Data/derive/make_small_examples.py [FOLDER]

writes branching_pipe.cnt, tamarind.csl and femur_head.csl into FOLDER, by default the folder above
this one. Needs nothing but Python 3. The thesis gives the numbers of planes, contours and points and
pictures, but no coordinates: the numbers are kept, the shapes are like the pictures.

The pipe is circles. Tamarind and femur are each one implicit surface f = 0 (negative inside) cut by
planes of three directions, so that contours agree where their planes cross: every vertex lies on the
surface to the 0.001 that is written. A contour is found by walking around a point inside it, so each
must be star-shaped about that point; the script checks that it has its point and its number of
vertices, which are evenly spaced along it.
"""
import math
import os
import sys

DENSE = 3600  # directions in which a contour is sought before it is sampled evenly


# ---- branching pipe: 9 contours, 4 planes 5 apart, 92 points --------------------------------------
# (z, points a circle, radius, centres): a trunk, two branches, the branches apart, each parted again.
PIPE = [
    (0.0, 16, 3.8, [(0.0, 0.0)]),
    (5.0, 12, 2.6, [(-3.2, 0.0), (3.2, 0.0)]),
    (10.0, 10, 2.4, [(-5.6, 0.0), (5.6, 0.0)]),
    (15.0, 8, 1.7, [(-6.8, -2.6), (-6.8, 2.6), (6.8, -2.6), (6.8, 2.6)]),
]


def circle(count, radius, centre):
    """Clockwise, as NUAGES wants an outer wall; no vertex on an axis of symmetry."""
    angles = [-2 * math.pi * (i + 0.5) / count for i in range(count)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def write_pipe(path):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("S %d\n" % len(PIPE))
        for z, count, radius, centres in PIPE:
            out.write("v %d z %.1f\n" % (count * len(centres), z))
            for centre in centres:
                out.write("{\n")
                out.writelines("%.3f %.3f\n" % p for p in circle(count, radius, centre))
                out.write("}\n")


# ---- implicit shapes ------------------------------------------------------------------------------
def tamarind(x, y, z):
    """A bent pod of length 20 along z with three swellings."""
    u = z / 10.0
    along = (1 - u * u) * (1 + 0.22 * math.cos(2.6 * math.pi * u))
    bend = 2.2 * (u * u - 0.35)
    return ((x - bend) / 3.2) ** 2 + (y / 2.4) ** 2 - along


def capsule(p, a, b, radius_a, radius_b):
    """Distance to the segment a-b, less a radius that goes from one end's to the other's."""
    ab = [b[i] - a[i] for i in range(3)]
    t = sum((p[i] - a[i]) * ab[i] for i in range(3)) / sum(c * c for c in ab)
    t = min(1.0, max(0.0, t))
    return math.dist(p, [a[i] + t * ab[i] for i in range(3)]) - (radius_a + t * (radius_b - radius_a))


def femur(x, y, z):
    """Head (a ball of 24 mm), neck, greater trochanter and the upper end of the shaft, blended."""
    p = (x, y, z)
    parts = [
        math.dist(p, (0, 0, 0)) - 24.0,
        capsule(p, (0, 0, 0), (44, 2, -34), 15.0, 16.0),
        math.dist(p, (50, -2, -34)) - 17.0,
        capsule(p, (50, 0, -36), (52, 0, -64), 17.0, 14.0),
    ]
    blend = 5.0  # mm: how far the parts' surfaces flow into one another
    return -blend * math.log(sum(math.exp(-d / blend) for d in parts))


# Planes: (axis of the normal, offset along it, vertices, a point inside the contour).
TAMARIND = (tamarind, [
    (2, -6.0, 10, (0.02, 0, -6)), (2, 0.0, 11, (-0.77, 0, 0)), (2, 6.0, 10, (0.02, 0, 6)),
    (1, 0.0, 14, (-0.6, 0, 0)), (0, 0.0, 12, (0, 0, 0)),
])
FEMUR = (femur, [
    (2, 14.0, 11, (0, 0, 14)), (2, 0.0, 12, (2, 0, 0)), (2, -16.0, 14, (12, 0, -16)),
    (2, -34.0, 14, (46, 0, -34)), (2, -58.0, 10, (52, 0, -58)),
    (1, -7.0, 20, (34, -7, -26)), (1, 8.0, 18, (34, 8, -26)),
    (0, -10.0, 9, (-10, 0, 0)), (0, 8.0, 9, (8, 0, -3)), (0, 27.0, 8, (27, 0, -21)),
    (0, 50.0, 11, (50, 0, -45)),
])


def boundary(f, inside, direction):
    """The first point of f = 0 from `inside` along a unit direction, by steps and bisection."""
    def at(s):
        return f(*[inside[i] + s * direction[i] for i in range(3)])

    step = 0.25
    far = step
    while at(far) < 0:
        far += step
        assert far < 1000, "the shape is not bounded"
    near = far - step
    for _ in range(60):
        middle = 0.5 * (near + far)
        near, far = (middle, far) if at(middle) < 0 else (near, middle)
    return [inside[i] + near * direction[i] for i in range(3)]


def section(f, axis, offset, count, inside):
    """A contour counterclockwise about the positive axis, vertices evenly spaced along it."""
    assert inside[axis] == offset and f(*inside) < 0, "the point is not inside the contour"
    u, v = (axis + 1) % 3, (axis + 2) % 3
    dense = []
    for i in range(DENSE):
        direction = [0.0, 0.0, 0.0]
        direction[u] = math.cos(2 * math.pi * i / DENSE)
        direction[v] = math.sin(2 * math.pi * i / DENSE)
        dense.append(boundary(f, inside, direction))
    lengths = [math.dist(dense[i], dense[(i + 1) % DENSE]) for i in range(DENSE)]
    spacing = sum(lengths) / count
    # A radial walk jumps where the contour is not star-shaped about its point.
    assert max(lengths) < 0.1 * spacing, "not star-shaped about %r" % (inside,)
    loop, travelled = [], 0.0
    for point, length in zip(dense, lengths):
        if len(loop) < count and travelled >= len(loop) * spacing - 1e-9:
            loop.append(point)
        travelled += length
    assert len(loop) == count
    return loop


def write_csl(path, f, planes):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("CSLC\n%d 2\n" % len(planes))
        for number, (axis, offset, count, inside) in enumerate(planes, 1):
            normal = [int(i == axis) for i in range(3)]
            loop = section(f, axis, offset, count, inside)
            out.write("\n%d %d 1 %d %d %d %g\n\n" % (number, count, *normal, 0.0 - offset))
            # "+ 0.0" turns a negative zero into a plain one
            out.writelines("%.3f %.3f %.3f\n" % tuple(round(c, 3) + 0.0 for c in p) for p in loop)
            out.write("\n%d 1 %s\n" % (count, " ".join(map(str, range(count)))))


def main(folder):
    write_pipe(os.path.join(folder, "branching_pipe.cnt"))
    write_csl(os.path.join(folder, "tamarind.csl"), *TAMARIND)
    write_csl(os.path.join(folder, "femur_head.csl"), *FEMUR)
    for name, planes in (("tamarind", TAMARIND[1]), ("femur_head", FEMUR[1])):
        print("%s: %d planes, %d points" % (name, len(planes), sum(plane[2] for plane in planes)))
    print("branching_pipe: %d planes, %d contours, %d points" % (
        len(PIPE), sum(len(p[3]) for p in PIPE), sum(p[1] * len(p[3]) for p in PIPE)))


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(here))
