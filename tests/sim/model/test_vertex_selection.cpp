// The vertices of a selection, on a box whose vertices are known.
#include "sim/model/vertex_selection.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/mesh/mesh_generate.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

using Indices = std::vector<std::uint32_t>;

/// A box of 2 x 4 x 1 cells of 1, group "top", and a vertex far below, in no tet.
struct Sample {
  TetMesh mesh = make_box(2, 4, 1, {2, 4, 1});
  std::vector<char> used;
  UpAxis up = UpAxis::y;
  Sample() {
    mesh.groups["top"] = where([](const Vector3d& x) { return x.y() == 4; });
    mesh.positions.push_back({0, -100, 0});
    mesh.groups["alone"] = {last()};
    used = used_vertices(mesh.tets, mesh.positions.size());
  }
  std::uint32_t last() const { return static_cast<std::uint32_t>(mesh.positions.size()) - 1; }
  template <class F>
  Indices where(F&& holds) const {
    Indices found;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      if (holds(mesh.positions[v])) found.push_back(v);
    return found;
  }
  Indices select(const Selection& selection) const {
    return select_vertices(selection, {mesh, mesh.tets, up}, "s.json: fixed");
  }
  std::string error_of(const Selection& selection) const {
    try {
      select(selection);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

}  // namespace

TEST_CASE("vertices of tets are used") {
  const Sample s;
  REQUIRE(s.used.size() == 31);
  for (std::size_t v = 0; v < 30; ++v) CHECK(s.used[v] == 1);
  CHECK(s.used[30] == 0);
}

TEST_CASE("boxes and spheres are closed, and take vertices of no tet beside others") {
  const Sample s;
  CHECK(s.select(BoxSelection{{0, 0, 0}, {1, 1, 1}}) ==
        s.where([](const Vector3d& x) { return x.x() <= 1 && x.y() >= 0 && x.y() <= 1; }));
  CHECK(s.select(SphereSelection{{1, 2, 0}, 1}).size() == 6);  // its center, four neighbors and the one behind
  CHECK(s.select(SphereSelection{{0, 0, 0}, 100}).size() == 31);
  CHECK_THAT(
      s.error_of(BoxSelection{{5, 0, 0}, {6, 1, 1}}),
      Catch::StartsWith("s.json: fixed: selects nothing; expected some of the 30 vertices, from (0, 0, 0) to (2, "
                        "4, 1)"));
  CHECK_THAT(s.error_of(BoxSelection{{-1, -101, -1}, {1, -99, 1}}),
             Catch::Contains("selects no vertex of a tet (1 unused)"));
}

TEST_CASE("indices are sorted, each once, and must exist") {
  const Sample s;
  CHECK(s.select(VertexSelection{{7, 3, 7, 0}}) == Indices{0, 3, 7});
  CHECK(s.error_of(VertexSelection{{0, 31}}) == "s.json: fixed: vertex 31 does not exist; expected 0 to 30");
  CHECK_THAT(s.error_of(VertexSelection{{30}}), Catch::Contains("selects no vertex of a tet (1 unused)"));
  CHECK_THAT(s.error_of(VertexSelection{}), Catch::Contains("selects nothing"));
}

TEST_CASE("middles of edges alone are no selection") {
  Sample s;
  MidEdges middles = kNoMidEdges;
  middles[0] = s.last();
  const auto error_of = [&](const Selection& selection) {
    try {
      select_vertices(selection, {s.mesh, s.mesh.tets, s.up, {&middles, 1}}, "s.json: fixed");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(error_of(VertexSelection{{s.last()}}) ==
        "s.json: fixed: selects no corner of a tet, only vertices in the middles of edges (1); expected some of the 30 "
        "corners, from (0, 0, 0) to (2, 4, 1)");
  CHECK(error_of(VertexSelection{{0, s.last()}}).empty());
  s.mesh.positions.push_back({0, -100, 0});  // in no tet
  CHECK_THAT(error_of(SphereSelection{{0, -100, 0}, 1}),
             Catch::Contains("selects no corner of a tet, only vertices in the middles of edges (1); expected"));
  CHECK_THAT(error_of(VertexSelection{{s.last()}}), Catch::Contains("selects no vertex of a tet (1 unused)"));
}

TEST_CASE("a group is that of its name") {
  Sample s;
  CHECK(s.select(GroupSelection{"top"}) == s.mesh.groups["top"]);
  CHECK(s.mesh.groups["top"].size() == 6);
  CHECK(s.error_of(GroupSelection{"Top"}) ==
        "s.json: fixed: the mesh has no group \"Top\", perhaps \"top\"; expected one of alone, top");
  CHECK_THAT(s.error_of(GroupSelection{"alone"}), Catch::Contains("selects no vertex of a tet"));
  s.mesh.groups.clear();
  CHECK_THAT(s.error_of(GroupSelection{"top"}), Catch::EndsWith("; expected a mesh with groups"));
}

TEST_CASE("the lowest vertices are those of a share of the height, and no fewer than that share of all") {
  const Sample s;
  const auto up_to = [&](double height) {
    return s.where([=](const Vector3d& x) { return x.y() >= 0 && x.y() <= height; });
  };
  CHECK(s.select(LowestSelection{0.02}) == up_to(0));
  CHECK(s.select(LowestSelection{0.25}) == up_to(1));
  CHECK(s.select(LowestSelection{0.5}) == up_to(2));
  CHECK(s.select(LowestSelection{1}) == up_to(4));

  Sample pyramid;  // a tip below: one vertex within a twentieth of the height
  for (Vector3d& x : pyramid.mesh.positions)
    if (x.y() > 0) x.y() += 50;
  pyramid.mesh.positions[0].y() -= 50;
  const Indices lowest = pyramid.select(LowestSelection{0.2});  // six of thirty, by their position
  CHECK(lowest.size() == 6);
}

TEST_CASE("lowest and highest follow the axis that points up") {
  Sample s;
  const auto on = [&](auto holds) { return s.where([&](const Vector3d& x) { return x.y() >= 0 && holds(x); }); };
  CHECK(s.select(LowestSelection{0.02, true}) == on([](const Vector3d& x) { return x.y() == 4; }));
  s.up = UpAxis::x;
  CHECK(s.select(LowestSelection{0.02}) == on([](const Vector3d& x) { return x.x() == 0; }));
  CHECK(s.select(LowestSelection{0.02, true}) == on([](const Vector3d& x) { return x.x() == 2; }));
  s.up = UpAxis::minus_z;
  CHECK(s.select(LowestSelection{0.02}) == on([](const Vector3d& x) { return x.z() == 1; }));
}

TEST_CASE("each connected piece has its own lowest vertices") {
  Sample s;  // and a second box above it
  const TetMesh above = make_box(1, 1, 1, {1, 1, 1});
  const auto first = static_cast<std::uint32_t>(s.mesh.positions.size());
  for (const Vector3d& p : above.positions) s.mesh.positions.push_back(p + Vector3d(0, 10, 0));
  for (Tet t : above.tets) {
    for (std::uint32_t& v : t) v += first;
    s.mesh.tets.push_back(t);
  }
  CHECK(s.select(LowestSelection{0.02}) == s.where([](const Vector3d& x) { return x.y() == 0; }));
  CHECK(s.select(LowestSelection{0.02, false, true}) ==
        s.where([](const Vector3d& x) { return x.y() == 0 || x.y() == 10; }));
}
