#include "tests/fuzz/fuzz.h"

#include <algorithm>
#include <stdexcept>

#include "base/error.h"

namespace fascia::fuzz {

void require(bool kept, const char* promise) {
  if (!kept) throw std::logic_error(promise);
}

bool run(Target target, std::string_view data) {
  try {
    target(data);
    return true;
  } catch (const Error& error) {
    const std::string_view text = error.what();
    require(!text.empty() && std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; }),
            "an error is one line of printable text");
    return false;
  }
}

void check_mesh(const TetMesh& mesh) {
  const std::size_t vertex_count = mesh.positions.size();
  require(!mesh.tets.empty(), "a mesh has tets");
  require(mesh.regions.size() == mesh.tets.size(), "every tet has a region");
  for (const Tet& tet : mesh.tets) {
    require(std::all_of(tet.begin(), tet.end(), [&](std::uint32_t v) { return v < vertex_count; }),
            "tets name vertices of the mesh");
  }
  for (const Eigen::Vector3d& x : mesh.positions) require(x.allFinite(), "positions are finite");
  for (const auto& [name, vertices] : mesh.groups) {
    require(std::is_sorted(vertices.begin(), vertices.end()), "groups are in order");
    require(std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end(), "groups name a vertex once");
    require(vertices.empty() || vertices.back() < vertex_count, "groups name vertices of the mesh");
  }
}

void check_file(const MeshFile& file) {
  if (!file.is_surface()) return check_mesh(file.mesh);
  const std::size_t vertex_count = file.mesh.positions.size();
  for (const Eigen::Vector3d& x : file.mesh.positions) require(x.allFinite(), "positions are finite");
  std::size_t begin = 0;
  for (const std::size_t end : file.faces.ends) {
    require(end >= begin + 3, "faces have three corners or more");
    begin = end;
  }
  require(begin == file.faces.corners.size(), "faces have all corners");
  for (const std::uint32_t v : file.faces.corners) require(v < vertex_count, "faces name vertices of the surface");
  require(file.vertex_colors.empty() || file.vertex_colors.size() == vertex_count, "all vertices have a color or none");
}

#ifndef FASCIA_LIBFUZZER
std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> all;
  return all;
}
#endif

}  // namespace fascia::fuzz
