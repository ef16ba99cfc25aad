#include "api/mesh.h"

#include "api/error.h"
#include "api/values.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia::api {
namespace {

Mesh shown(const TetMesh& mesh) {
  Mesh out;
  out.positions = numbers_of(mesh.positions);
  out.tets.reserve(4 * mesh.tets.size());
  for (const Tet& tet : mesh.tets) out.tets.insert(out.tets.end(), tet.begin(), tet.end());
  out.regions = mesh.regions;
  out.region_names = mesh.region_names;
  out.groups = mesh.groups;
  return out;
}

}  // namespace

TetMesh checked(const Mesh& mesh, const std::string& where) {
  if (mesh.positions.size() % 3 != 0)
    throw Error(where + ".positions", "has " + std::to_string(mesh.positions.size()) + " numbers",
                "expected three a vertex");
  if (mesh.tets.empty() || mesh.tets.size() % 4 != 0)
    throw Error(where + ".tets", "has " + std::to_string(mesh.tets.size()) + " indices",
                "expected four a tet, and at least one tet");
  if (!mesh.regions.empty() && mesh.regions.size() != mesh.tet_count())
    throw Error(where + ".regions", "has " + std::to_string(mesh.regions.size()) + " numbers",
                "expected one a tet, " + std::to_string(mesh.tet_count()) + ", or none");
  TetMesh own;
  own.positions = vectors_of(mesh.positions, mesh.vertex_count(), where + ".positions");
  own.tets.resize(mesh.tet_count());
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    if (mesh.tets[i] >= mesh.vertex_count())
      throw Error(where + ".tets", "names vertex " + std::to_string(mesh.tets[i]) + " in tet " + std::to_string(i / 4),
                  "expected an index below " + std::to_string(mesh.vertex_count()));
    own.tets[i / 4][i % 4] = mesh.tets[i];
  }
  own.regions = mesh.regions;
  own.regions.resize(own.tets.size(), 0);
  own.region_names = mesh.region_names;
  own.groups = mesh.groups;
  return own;
}

Mesh make_box(int nx, int ny, int nz, const Vec3& size) {
  if (nx < 1 || ny < 1 || nz < 1) throw Error("make_box", "cells below 1", "expected at least one along each axis");
  const Eigen::Vector3d edges = vector_of(size, "make_box: size");
  if (!(edges.minCoeff() > 0)) throw Error("make_box: size", "is not positive", "expected three lengths [m]");
  return shown(fascia::make_box(nx, ny, nz, edges));
}

Mesh read_mesh(const std::string& path, const Control& control) {
  return translated([&] { return shown(fascia::read_mesh(path, progress_of(control, path)).mesh); });
}

}  // namespace fascia::api
