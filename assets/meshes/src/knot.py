# A vessel with an overhand knot as a surface: knot.py OUT.obj. A trefoil that is cut open, with straight ends along x.
# In metres.
import math
import sys

AROUND, RADIUS, SCALE, ENDS = 10, 0.005, 0.016, 0.13
RINGS, RINGS_OF_END = 96, 24
APART = 0.7  # how far the ends are moved out of each other's way along z, over SCALE


def knot(t):  # -pi to pi
    z = -1.8 * math.sin(3 * t) - APART * t / math.pi
    return [SCALE * c for c in (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), z)]


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return [p / length for p in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


middle = [knot(math.pi * (2 * i / RINGS - 1)) for i in range(RINGS + 1)]
first, last = middle[0], middle[-1]
steps = [ENDS * (k + 1) / RINGS_OF_END for k in range(RINGS_OF_END)]
middle = [[first[0] - s, first[1], first[2]] for s in reversed(steps)] + middle + [[last[0] + s, last[1], last[2]] for s in steps]
for _ in range(4):  # rounds the corners between the knot and its ends
    middle = [middle[0]] + [[(a + 2 * b + c) / 4 for a, b, c in zip(*middle[i - 1 : i + 2])] for i in range(1, len(middle) - 1)] + [middle[-1]]

vertices, triangles = [], []
side = [0.0, 0.0, 1.0]
for i, center in enumerate(middle):
    along = unit(minus(middle[min(i + 1, len(middle) - 1)], middle[max(i - 1, 0)]))
    side = unit(minus(side, [dot(side, along) * c for c in along]))  # carried along without twist
    other = cross(along, side)
    for k in range(AROUND):
        angle = 2 * math.pi * k / AROUND
        vertices.append([c + RADIUS * (math.cos(angle) * s + math.sin(angle) * o) for c, s, o in zip(center, side, other)])
for i in range(len(middle) - 1):
    for k in range(AROUND):
        a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
        triangles += [(a, b, b + AROUND), (a, b + AROUND, a + AROUND)]
for i in (0, len(middle) - 1):
    tip = len(vertices)
    vertices.append(middle[i])
    for k in range(AROUND):
        a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
        triangles.append((b, a, tip) if i == 0 else (a, b, tip))

with open(sys.argv[1], "w") as out:
    out.write("# A vessel with an overhand knot, its ends along x [m]\n")
    for v in vertices:
        out.write("v %.5f %.5f %.5f\n" % tuple(v))
    for t in triangles:
        out.write("f %d %d %d\n" % tuple(c + 1 for c in t))
