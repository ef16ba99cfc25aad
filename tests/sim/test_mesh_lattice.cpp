#include "sim/surface_fill.h"
#include <catch2/catch.hpp>
#include <chrono>
#include <numbers>
#include <iostream>
#include "sim/mesh_doctor.h"
using namespace fascia;
static SurfaceMesh torus(int n,int m,double R,double r,Eigen::Vector3d c={0,0,0}){SurfaceMesh s;
for(int i=0;i<n;i++)for(int j=0;j<m;j++){double a=2*std::numbers::pi*i/n,b=2*std::numbers::pi*j/m;s.positions.push_back(c+Eigen::Vector3d((R+r*cos(b))*cos(a),r*sin(b),(R+r*cos(b))*sin(a)));
auto id=[&](int p,int q){return uint32_t((p%n)*m+q%m);};s.triangles.push_back({id(i,j),id(i,j+1),id(i+1,j)});s.triangles.push_back({id(i+1,j),id(i,j+1),id(i+1,j+1)});}return s;}
TEST_CASE("try lattice"){
 for(int k=0;k<4;k++){
 SurfaceMesh s= k==0?torus(64,32,0.1,0.04): k==1?torus(400,125,0.1,0.02): k==2? torus(400,125,0.1,0.002): torus(20,12,0.1,0.06);
 for(int res: {0,5,10,20,40}){
 auto t0=std::chrono::steady_clock::now();
 FilledSurface f=fill_surface(s,"x",res?std::optional<int>(res):std::nullopt);
 double sec=std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count();
 auto rep=repair(f.file.mesh); auto r=examine(f.file.mesh,rep);
 std::cout<<k<<" res "<<f.resolution<<" tets "<<r.tet_count<<" dihedral "<<r.smallest_dihedral_deg<<" "<<r.largest_dihedral_deg<<" vol "<<r.volume/f.repaired.report.volume<<" comps "<<r.components<<" manifold "<<r.boundary_manifold<<" nme "<<r.nonmanifold_edges<<" nmv "<<r.nonmanifold_vertices<<" s "<<sec<<" flipped "<<r.flipped<<" deg "<<r.degenerate<<std::endl;
 for(auto&n:f.file.notes)std::cout<<"   "<<n<<"\n";
 double h=f.repaired.report.box.sizes().maxCoeff()/f.resolution;std::cout<<"   inside part "<<12*f.repaired.report.volume/h/h/h<<" area/h2 "<<f.repaired.report.area/h/h<<"\n";
 }}
}
