// A tapered band that hangs in a shallow arch and swings sideways, lofted through sections that stand across its
// middle line. Its two end faces are where bone would hold it.
SetFactory("OpenCASCADE");
length = 0.12;
sections = 9;
points = 16;
For s In {0:sections - 1}
  u = s / (sections - 1);
  // Middle line, its direction t, and the section's axes: b across the band, n through its thickness.
  x = length * (u - 0.5);
  y = -0.020 * Sin(Pi * u);
  z = 0.009 * Sin(2 * Pi * u);
  tx = length;
  ty = -0.020 * Pi * Cos(Pi * u);
  tz = 0.009 * 2 * Pi * Cos(2 * Pi * u);
  t = Sqrt(tx * tx + ty * ty + tz * tz);
  tx /= t;
  ty /= t;
  tz /= t;
  b = Sqrt(1 - tz * tz);
  bx = -tz * tx / b;
  by = -tz * ty / b;
  bz = (1 - tz * tz) / b;
  nx = by * tz - bz * ty;
  ny = bz * tx - bx * tz;
  nz = bx * ty - by * tx;
  flare = (2 * u - 1)^2;
  half_width = 0.010 + 0.008 * flare;
  half_thickness = 0.0042 + 0.0022 * flare;
  first = newp;
  For p In {0:points - 1}
    angle = 2 * Pi * p / points;
    // A superellipse: flatter than an ellipse, without corners.
    c = Cos(angle);
    d = Sin(angle);
    r = (c^4 + d^4)^(-0.25);
    i = half_width * r * c;
    j = half_thickness * r * d;
    Point(first + p) = {x + i * bx + j * nx, y + i * by + j * ny, z + i * bz + j * nz};
  EndFor
  curve = newc;
  Spline(curve) = {first:first + points - 1, first};
  Curve Loop(100 + s) = {curve};
EndFor
ThruSections(1) = {100:100 + sections - 1};
left[] = Surface In BoundingBox {-0.5 * length - 0.02, -1, -1, -0.5 * length + 0.02, 1, 1};
right[] = Surface In BoundingBox {0.5 * length - 0.02, -1, -1, 0.5 * length + 0.02, 1, 1};
Physical Volume("ligament") = {1};
Physical Surface("clamp_left") = left[];
Physical Surface("clamp_right") = right[];
Mesh.MeshSizeMin = 0.00284;
Mesh.MeshSizeMax = 0.00284;
