# A kidney with its artery, vein and ureter, as a surface with a color at every vertex: kidney.py OUT.obj.
# Five closed shells that overlap, in metres; y is up, the hilum is on the side of +x. A modelled shape, no patient's.
import math
import sys


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def bumps(p, scale):
    """Smooth and irregular, about -1 to 1."""
    x, y, z = (c * scale for c in p)
    return (math.sin(1.7 * x + 1.3 * math.sin(1.1 * z)) + math.sin(1.9 * y + 1.1 * math.sin(1.3 * x)) + math.sin(2.1 * z + 1.2 * math.sin(0.9 * y))) / 3


def kidney(rings, around):
    """A ball, stretched, bent to a bean and dented at the hilum."""
    def vertex(i, j):
        polar, turn = math.pi * i / rings, 2 * math.pi * j / around
        sx, sy, sz = math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)
        dent = math.exp(-((sy / 0.42) ** 2 + (sz / 0.55) ** 2)) if sx > 0 else 0.0
        swell = 1 + 0.02 * bumps((sx, sy, sz), 4.2) + 0.008 * bumps((sx, sy, sz), 11)
        p = (0.030 * sx * swell - 0.009 * (1 - sy * sy) - 0.016 * dent * sx * sx, 0.056 * sy * swell,
             0.023 * sz * swell * (1 - 0.12 * sy))
        mottle = 0.5 + 0.25 * bumps((sx, sy, sz), 9) + 0.25 * bumps((sy + sz, sz - sx, sx + sy), 21)
        color = mix((0.56, 0.20, 0.16), (0.70, 0.31, 0.23), mottle)
        color = mix(color, (0.88, 0.72, 0.45), min(1.0, 1.25 * max(0.0, dent * sx - 0.25)))  # fat of the hilum
        return p, color

    vertices = [vertex(0, 0)] + [vertex(i, j) for i in range(1, rings) for j in range(around)] + [vertex(rings, 0)]
    return vertices, ball_faces(rings, around)


def ball_faces(rings, around):
    faces, last = [], 1 + (rings - 1) * around
    for j in range(around):
        k = (j + 1) % around
        faces += [(0, 1 + k, 1 + j), (last, 1 + (rings - 2) * around + j, 1 + (rings - 2) * around + k)]
        for i in range(rings - 2):
            a, b = 1 + i * around + j, 1 + i * around + k
            faces += [(a, b, b + around), (a, b + around, a + around)]
    return faces


def spline(points, t):
    """Catmull-Rom through the points, t from 0 to 1."""
    spans = len(points) - 1
    k = min(int(t * spans), spans - 1)
    s = t * spans - k
    p1, p2 = points[k], points[k + 1]
    p0 = points[k - 1] if k > 0 else add(p1, add(p1, p2, -1))
    p3 = points[k + 2] if k + 2 < len(points) else add(p2, add(p2, p1, -1))
    return tuple(b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a))) for a, b, c, d in zip(p0, p1, p2, p3))


def tube(points, radii, color, steps, around):
    """A round tube with rounded ends; radii along it as the points."""
    centers = [spline(points, i / steps) for i in range(steps + 1)]
    thick = [spline([(r,) for r in radii], i / steps)[0] for i in range(steps + 1)]
    rings, side = [], None
    for i, center in enumerate(centers):
        along = unit(add(centers[min(i + 1, steps)], centers[max(i - 1, 0)], -1))
        side = side or unit(cross(along, (0.3, 0.2, 1.0)))
        side = unit(add(side, along, -dot(side, along)))  # carried along without twisting
        if i == 0:
            rings += [(add(center, along, -thick[0] * math.cos(a)), thick[0] * math.sin(a), along, side) for a in (0.4, 0.8, 1.2)]
        rings.append((center, thick[i] * (1 + 0.025 * math.sin(0.9 * i)), along, side))
        if i == steps:
            rings += [(add(center, along, thick[i] * math.cos(a)), thick[i] * math.sin(a), along, side) for a in (1.2, 0.8, 0.4)]
    first, last = add(centers[0], rings[0][2], -thick[0]), add(centers[-1], rings[-1][2], thick[-1])
    vertices = [(first, color)]
    for center, radius, along, u in rings:
        v = cross(along, u)
        for j in range(around):
            a = 2 * math.pi * j / around
            p = add(add(center, u, radius * math.cos(a)), v, radius * math.sin(a))
            vertices.append((p, mix(color, tuple(0.78 * c for c in color), 0.5 + 0.5 * bumps(p, 420))))
    return vertices + [(last, color)], ball_faces(len(rings) + 1, around)


artery, vein, ureter = (0.80, 0.16, 0.15), (0.33, 0.30, 0.55), (0.90, 0.78, 0.52)
shells = [
    kidney(72, 112),
    tube([(-0.004, 0.016, -0.006), (0.012, 0.011, -0.005), (0.026, 0.006, -0.005), (0.045, 0.004, -0.005), (0.070, 0.006, -0.006)],
         [0.0030, 0.0036, 0.0046, 0.0048, 0.0048], artery, 44, 20),
    tube([(-0.004, -0.012, -0.006), (0.012, -0.006, -0.005), (0.026, 0.004, -0.005), (0.036, 0.0045, -0.005)],
         [0.0028, 0.0034, 0.0038, 0.0030], artery, 32, 18),
    tube([(-0.004, 0.002, 0.007), (0.012, 0.001, 0.008), (0.030, 0.003, 0.008), (0.050, 0.008, 0.007), (0.072, 0.010, 0.007)],
         [0.0050, 0.0056, 0.0062, 0.0066, 0.0066], vein, 44, 22),
    tube([(-0.004, -0.006, 0.001), (0.010, -0.009, 0.001), (0.021, -0.018, 0.001), (0.026, -0.036, 0.001), (0.027, -0.058, 0.0), (0.030, -0.078, -0.001)],
         [0.0070, 0.0064, 0.0046, 0.0034, 0.0031, 0.0031], ureter, 56, 18),
]

with open(sys.argv[1], "w", encoding="ascii") as out:
    out.write("# A kidney with artery, vein and ureter; made by fascia's assets/meshes/src/kidney.py (MIT licence). Metres, y up.\n")
    before = 1
    for vertices, faces in shells:
        for p, color in vertices:
            out.write("v " + " ".join(f"{c:.5f}" for c in p) + " " + " ".join(f"{c:.3f}" for c in color) + "\n")
        for face in faces:
            out.write("f " + " ".join(str(before + v) for v in face) + "\n")
        before += len(vertices)
