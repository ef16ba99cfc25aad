#include "sim/mesh/linear_tets.h"

#include <Eigen/Geometry>

namespace fascia {

std::array<Tet, 8> cut_in_eight(const Tet& c, const MidEdges& m, const std::vector<Eigen::Vector3d>& x) {
  const auto [m01, m12, m02, m03, m13, m23] = m;
  std::array<Tet, 8> parts{
      {{c[0], m01, m02, m03}, {m01, c[1], m12, m13}, {m02, m12, c[2], m23}, {m03, m13, m23, c[3]}}};
  // Diagonals with the ring of the four other vertices around each, counterclockwise seen from its end
  struct Diagonal {
    std::uint32_t from, to;
    std::array<std::uint32_t, 4> ring;
  };
  const std::array<Diagonal, 3> diagonals{
      {{m01, m23, {m02, m03, m13, m12}}, {m02, m13, {m01, m12, m23, m03}}, {m03, m12, {m01, m02, m23, m13}}}};
  const Diagonal* shortest = &diagonals[0];
  const auto length = [&](const Diagonal& d) { return (x[d.to] - x[d.from]).norm(); };
  for (const Diagonal& d : diagonals)
    if (length(d) < (1 - 1e-9) * length(*shortest)) shortest = &d;
  for (std::size_t k = 0; k < 4; ++k) {
    Tet tet{shortest->from, shortest->to, shortest->ring[k], shortest->ring[(k + 1) % 4]};
    const Eigen::Vector3d a = x[tet[1]] - x[tet[0]], b = x[tet[2]] - x[tet[0]], e = x[tet[3]] - x[tet[0]];
    if (a.cross(b).dot(e) < 0) std::swap(tet[2], tet[3]);
    parts[4 + k] = tet;
  }
  return parts;
}

LinearTets linear_tets(const std::vector<Tet>& tets, const std::vector<MidEdges>& mid_edges,
                       const std::vector<Eigen::Vector3d>& positions, std::size_t begin, std::size_t count) {
  LinearTets linear;
  const auto add = [&](const Tet& tet, std::size_t t) {
    linear.tets.push_back(tet);
    linear.source.push_back(static_cast<std::uint32_t>(t));
  };
  for (std::size_t t = begin; t < begin + count; ++t) {
    if (mid_edges.empty() || mid_edges[t] == kNoMidEdges) {
      add(tets[t], t);
      continue;
    }
    for (const Tet& tet : cut_in_eight(tets[t], mid_edges[t], positions)) add(tet, t);
  }
  return linear;
}

}  // namespace fascia
