// Two boxes that share a face, with a named volume, surface and point.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Mesh.MeshSizeMin = 10;
Mesh.MeshSizeMax = 10;
Physical Volume("soft part", 7) = {1};
Physical Volume("hard", 3) = {2};
Physical Surface("clamp", 11) = Surface In BoundingBox {-0.01, -1, -1, 0.01, 2, 2};
Physical Point("tip", 9) = {1};
