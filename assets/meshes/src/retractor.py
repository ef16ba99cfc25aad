# A retractor as a surface: retractor.py OUT.obj. A handle along x that widens to a blade, whose end is bent up. In millimetres.
import math
import sys

AROUND, THICKNESS, HANDLE, BLADE = 12, 9.0, 18.0, 40.0
BEND, TURN = 40.0, 30  # radius of the bent end, and its angle in degrees

middle = [(160.0 - 10 * i, 0.0) for i in range(14)]
straight = len(middle)
middle += [(30 - BEND * math.sin(math.radians(a)), BEND - BEND * math.cos(math.radians(a))) for a in range(10, TURN + 1, 10)]
last = len(middle) - 1


def across(i):
    (ax, ay), (bx, by) = middle[max(i - 1, 0)], middle[min(i + 1, last)]
    length = math.hypot(bx - ax, by - ay)
    return (ay - by) / length, (bx - ax) / length


def width(i):
    return HANDLE + (BLADE - HANDLE) * min(max((i - (straight - 5)) / 4, 0), 1)


def rounded(c):
    return math.copysign(math.sqrt(abs(c)), c)


vertices, triangles = [], []
for i, (x, y) in enumerate(middle):
    ends = i in (0, last)
    up = across(i)
    for k in range(AROUND):
        angle = 2 * math.pi * k / AROUND
        height = 0.5 * THICKNESS * (0.6 if ends else 1) * rounded(math.sin(angle))
        side = 0.5 * width(i) * (0.9 if ends else 1) * rounded(math.cos(angle))
        vertices.append((x + height * up[0], y + height * up[1], side))
for i in range(last):
    for k in range(AROUND):
        a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
        triangles += [(a, b + AROUND, b), (a, a + AROUND, b + AROUND)]
for i in (0, last):
    tip = len(vertices)
    vertices.append((*middle[i], 0.0))
    for k in range(AROUND):
        a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
        triangles.append((a, b, tip) if i == 0 else (b, a, tip))

with open(sys.argv[1], "w") as out:
    out.write("# A retractor: a handle along x, and a blade that is bent up at its end [mm]\n")
    for v in vertices:
        out.write("v %.2f %.2f %.2f\n" % v)
    for t in triangles:
        out.write("f %d %d %d\n" % tuple(c + 1 for c in t))
