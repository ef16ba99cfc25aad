// Fills the surface that liver.py makes: remeshes it evenly, then meshes the inside.
Merge "liver.stl";
ClassifySurfaces{Pi, 1, 1, Pi};  // the surface is smooth: cut it only where the parametrisation needs it
CreateGeometry;
Surface Loop(1) = Surface{:};
Volume(1) = {1};
Physical Volume("liver") = {1};
Mesh.MeshSizeMin = 0.00985;
Mesh.MeshSizeMax = 0.00985;
