#!/usr/bin/env python3
"""Write a displaced sphere of a million triangles as an OBJ file.

    python3 sphere.py OUT.obj [COLUMNS ROWS]      # 2 * COLUMNS * (ROWS - 1) triangles; 1000 and 501 if left out

Radius: 1 + 0.08 sin(12 phi) sin(9 theta) + 0.02 sin(67 phi) sin(53 theta).
"""
import sys
from math import cos, pi, sin

path = sys.argv[1]
columns, rows = (int(x) for x in (sys.argv[2:4] or (1000, 501)))
with open(path, "w") as out:
    out.write("v 0 1 0\nv 0 -1 0\n")
    for row in range(1, rows):
        for column in range(columns):
            theta, phi = pi * row / rows, 2 * pi * column / columns
            r = 1 + 0.08 * sin(12 * phi) * sin(9 * theta) + 0.02 * sin(67 * phi) * sin(53 * theta)
            out.write("v %.9g %.9g %.9g\n" % (r * sin(theta) * cos(phi), r * cos(theta), r * sin(theta) * sin(phi)))
    vertex = lambda row, column: 3 + (row - 1) * columns + column % columns
    for column in range(columns):
        out.write("f 1 %d %d\n" % (vertex(1, column + 1), vertex(1, column)))
        out.write("f 2 %d %d\n" % (vertex(rows - 1, column), vertex(rows - 1, column + 1)))
    for row in range(1, rows - 1):
        for column in range(columns):
            a, b = vertex(row, column), vertex(row, column + 1)
            c, d = vertex(row + 1, column), vertex(row + 1, column + 1)
            out.write("f %d %d %d\nf %d %d %d\n" % (a, b, c, b, d, c))
