// A small cube that hangs from its upper face. Four edges are cut into five, the others into four: that gives 500 tets.
SetFactory("OpenCASCADE");
Box(1) = {-0.05, 0, -0.05, 0.1, 0.1, 0.1};
Physical Volume("tissue") = {1};
Physical Surface("clamp") = Surface In BoundingBox {-1, 0.099, -1, 1, 0.101, 1};
Transfinite Curve{1, 3, 5, 7, 9, 10, 11, 12} = 5;
Transfinite Curve{2, 4, 6, 8} = 6;
Mesh.MeshSizeMin = 0.022;
Mesh.MeshSizeMax = 0.025;
