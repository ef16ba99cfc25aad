#!/usr/bin/env python3
"""Writes the surface of a liver-like organ as an STL file: liver.py OUT.stl

The shape is an implicit function, blended from ellipsoids, in centimetres as seen from the front: x to the viewer's
right (the organ's left), y up, z towards the viewer. Its zero level is found by surface nets on a regular grid.
"""
import math
import struct
import sys

GRID = 0.4  # [cm]
BOX = ((-14.0, 14.0), (-10.0, 10.0), (-7.0, 7.0))  # [cm]


def ellipsoid(center, radii, tilt_deg=0.0):
    """Approximate signed distance to an ellipsoid that is tilted about z."""
    c, s = math.cos(math.radians(tilt_deg)), math.sin(math.radians(tilt_deg))
    (cx, cy, cz), (rx, ry, rz) = center, radii

    def distance(x, y, z):
        x, y, z = x - cx, y - cy, z - cz
        x, y = (c * x + s * y) / rx, (c * y - s * x) / ry
        z /= rz
        k0 = math.sqrt(x * x + y * y + z * z)
        k1 = math.sqrt((x / rx) ** 2 + (y / ry) ** 2 + (z / rz) ** 2)
        return k0 * (k0 - 1) / k1 if k1 > 0 else -min(radii)

    return distance


def smooth_min(a, b, width):
    h = max(width - abs(a - b), 0.0) / width
    return min(a, b) - h * h * width / 4


LOBES = [
    ellipsoid((-5.4, 0.9, -0.3), (6.8, 6.4, 5.4)),           # right lobe under its dome
    ellipsoid((-8.0, -4.2, 0.2), (3.8, 4.4, 3.4), -12),      # its lower tip
    ellipsoid((2.6, 1.9, 0.3), (7.6, 4.7, 3.8), -4),         # left lobe
    ellipsoid((8.6, 2.6, 0.5), (4.4, 2.8, 2.2), 4),          # its thin end
]
HOLLOWS = [
    (ellipsoid((1.0, -8.5, -7.5), (12.0, 9.0, 8.6)), 2.0),   # stomach and kidney press in from below and behind
    (ellipsoid((1.5, -3.4, 1.5), (1.2, 2.6, 6.0), -10), 1.6),  # the notch between the lobes
    (ellipsoid((2.0, 1.5, 5.3), (0.9, 6.5, 1.9), -6), 1.8),  # and the furrow that runs up from it in front
]


def organ(x, y, z):
    value = 1e9
    for lobe in LOBES:
        value = smooth_min(value, lobe(x, y, z), 2.5)
    for hollow, width in HOLLOWS:
        value = -smooth_min(-value, hollow(x, y, z), width)
    return value


def surface_nets(function):
    """Vertices and outward quads of the zero level: one vertex per cell that the surface crosses."""
    counts = [round((high - low) / GRID) + 1 for low, high in BOX]
    nx, ny, nz = counts

    def point(i, j, k):
        return BOX[0][0] + GRID * i, BOX[1][0] + GRID * j, BOX[2][0] + GRID * k

    values = [[[function(*point(i, j, k)) for k in range(nz)] for j in range(ny)] for i in range(nx)]
    vertices, index = [], {}

    def vertex(i, j, k):
        if (i, j, k) not in index:
            crossings = []
            corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
            for a in corners:
                for b in corners:
                    if sum(b) - sum(a) != 1 or sum(abs(p - q) for p, q in zip(a, b)) != 1:
                        continue
                    u = values[i + a[0]][j + a[1]][k + a[2]]
                    v = values[i + b[0]][j + b[1]][k + b[2]]
                    if (u < 0) != (v < 0):
                        t = u / (u - v)
                        crossings.append([p + t * (q - p) for p, q in zip(a, b)])
            mean = [sum(c) / len(crossings) for c in zip(*crossings)]
            index[i, j, k] = len(vertices)
            vertices.append(list(point(i + mean[0], j + mean[1], k + mean[2])))
        return index[i, j, k]

    quads = []
    for i in range(1, nx - 1):
        for j in range(1, ny - 1):
            for k in range(1, nz - 1):
                inside = values[i][j][k] < 0
                for axis in range(3):
                    far = (i + (axis == 0), j + (axis == 1), k + (axis == 2))
                    if (values[far[0]][far[1]][far[2]] < 0) == inside:
                        continue
                    u, v = (axis + 1) % 3, (axis + 2) % 3
                    ring = []
                    for du, dv in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
                        cell = [i, j, k]
                        cell[u] += du
                        cell[v] += dv
                        ring.append(vertex(*cell))
                    quads.append(ring if inside else ring[::-1])
    return vertices, quads


def relax(vertices, quads, function, rounds):
    """Evens the quads out along the surface and puts their corners back onto it."""
    neighbours = [set() for _ in vertices]
    for quad in quads:
        for n in range(4):
            neighbours[quad[n]] |= {quad[(n + 1) % 4], quad[(n + 3) % 4]}
    step = 1e-3
    for _ in range(rounds):
        means = [[sum(vertices[n][c] for n in ring) / len(ring) for c in range(3)] for ring in neighbours]
        for n, (x, y, z) in enumerate(means):
            value = function(x, y, z)
            gradient = [(function(x + step, y, z) - value) / step, (function(x, y + step, z) - value) / step,
                        (function(x, y, z + step) - value) / step]
            scale = value / sum(g * g for g in gradient)
            vertices[n] = [p - scale * g for p, g in zip((x, y, z), gradient)]


def write_stl(path, vertices, quads):
    with open(path, "wb") as out:
        out.write(b"liver".ljust(80) + struct.pack("<I", 2 * len(quads)))
        for a, b, c, d in quads:
            for triangle in ((a, b, c), (a, c, d)):
                out.write(struct.pack("<12fH", 0, 0, 0, *(0.01 * p for n in triangle for p in vertices[n]), 0))


if __name__ == "__main__":
    nodes, faces = surface_nets(organ)
    relax(nodes, faces, organ, 5)
    write_stl(sys.argv[1], nodes, faces)
