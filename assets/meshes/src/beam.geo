// A cantilever: clamped at x = 0, free at x = 0.4 m.
SetFactory("OpenCASCADE");
Box(1) = {0, -0.05, -0.05, 0.4, 0.1, 0.1};
Physical Volume("tissue") = {1};
Physical Surface("clamp") = Surface In BoundingBox {-1e-3, -1, -1, 1e-3, 1, 1};
Mesh.MeshSizeMin = 0.0162;
Mesh.MeshSizeMax = 0.0162;
