// A block of tissue that stands on its lower face, with a stiff ball inside, nearer to the front and to the top.
SetFactory("OpenCASCADE");
Box(1) = {-0.08, 0, -0.05, 0.16, 0.1, 0.1};
Sphere(2) = {0.02, 0.058, 0.012, 0.026};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("tissue") = {3};
Physical Volume("tumour") = {2};
Physical Surface("clamp") = Surface In BoundingBox {-1, -1e-3, -1, 1, 1e-3, 1};
Mesh.MeshSizeMin = 0.0115;
Mesh.MeshSizeMax = 0.0115;
