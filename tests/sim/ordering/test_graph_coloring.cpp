// Colorings: valid, repeatable, balanced.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <set>

#include "sim/mesh/mesh_generate.h"
#include "sim/ordering/graph_coloring.h"
#include "sim/ordering/morton_order.h"

using namespace fascia;

namespace {

std::vector<std::uint32_t> file_order(const std::vector<Tet>& tets) {
  std::vector<std::uint32_t> order(tets.size());
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

// Checks that no two tets of a color move the same vertex or phantom, and that every corner moves its vertex or a
// phantom of it.
void check_valid(const std::vector<Tet>& tets, const std::vector<char>& held, const Coloring& coloring) {
  REQUIRE(coloring.order.size() == tets.size());
  REQUIRE(coloring.corners.size() == tets.size());
  CHECK(std::set<std::uint32_t>(coloring.order.begin(), coloring.order.end()).size() == tets.size());
  CHECK(coloring.begin.back() == tets.size());
  for (std::size_t color = 0; color < coloring.color_count(); ++color) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = coloring.begin[color]; i < coloring.begin[color + 1]; ++i)
      for (int a = 0; a < 4; ++a) {
        const std::uint32_t t = coloring.order[i], v = tets[t][a], moved = coloring.corners[t][a];
        CAPTURE(color, t, v, moved);
        if (moved != v) REQUIRE(coloring.phantom_vertex.at(moved - held.size()) == v);
        if (!held[v]) REQUIRE(seen.insert(moved).second);
      }
    CHECK(!seen.empty());
  }
}

}  // namespace

TEST_CASE("no two tets of a color share a free vertex") {
  const TetMesh mesh = make_box(7, 5, 4, {0.7, 0.5, 0.4});
  std::vector<char> held(mesh.positions.size(), 0);
  const Coloring free = color_tets(mesh.tets, held, file_order(mesh.tets));
  check_valid(mesh.tets, held, free);
  for (std::size_t v = 0; v < held.size(); ++v) held[v] = mesh.positions[v].x() < 0.35;
  const Coloring clamped = color_tets(mesh.tets, held, file_order(mesh.tets));
  check_valid(mesh.tets, held, clamped);
  CAPTURE(free.color_count(), clamped.color_count());
  CHECK(clamped.color_count() <= free.color_count());
}

TEST_CASE("a coloring needs at least the largest valence and repeats") {
  const TetMesh mesh = make_box(6, 6, 6, {1, 1, 1});
  const std::vector<char> held(mesh.positions.size(), 0);
  std::vector<std::size_t> valence(mesh.positions.size(), 0);
  for (const Tet& tet : mesh.tets)
    for (const auto v : tet) ++valence[v];
  const std::size_t largest = *std::max_element(valence.begin(), valence.end());
  const Coloring a = color_tets(mesh.tets, held, file_order(mesh.tets)),
                 b = color_tets(mesh.tets, held, file_order(mesh.tets));
  CAPTURE(a.color_count(), largest);
  CHECK(a.color_count() >= largest);
  CHECK(a.color_count() <= 2 * largest);
  CHECK(a.order == b.order);
  CHECK(a.begin == b.begin);
}

TEST_CASE("phantoms limit the colors to the requested number") {
  const TetMesh mesh = make_box(8, 5, 5, {0.8, 0.5, 0.5});
  std::vector<char> held(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < held.size(); ++v) held[v] = mesh.positions[v].x() < 1e-9;
  std::vector<std::size_t> valence(mesh.positions.size(), 0);
  for (const Tet& tet : mesh.tets)
    for (const auto v : tet) ++valence[v];
  const auto visit = curve_order(mesh.positions, mesh.tets);
  const std::size_t colors = GENERATE(1, 2, 5, 12, 24, 64);
  const Coloring c = color_tets(mesh.tets, held, visit, static_cast<std::uint32_t>(colors));
  check_valid(mesh.tets, held, c);
  // Each vertex needs at least ceil(valence / colors) copies.
  std::size_t least = 0;
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v] && valence[v] > 0) least += (valence[v] - 1) / colors;
  CAPTURE(colors, c.color_count(), c.phantom_vertex.size(), least);
  CHECK(c.color_count() == colors);
  CHECK(c.phantom_vertex.size() >= least);
  CHECK(c.phantom_vertex.size() <=
        least + mesh.positions.size());  // greedy: on average at most one copy more than needed
  CHECK(std::is_sorted(c.phantom_vertex.begin(), c.phantom_vertex.end()));
  if (colors == 1) CHECK(c.phantom_vertex.size() == least);
  if (colors == 64) CHECK(c.phantom_vertex.empty());
  const Coloring again = color_tets(mesh.tets, held, visit, static_cast<std::uint32_t>(colors));
  CHECK(again.order == c.order);
  CHECK(again.corners == c.corners);
  for (std::size_t color = 0; color < colors; ++color) {
    CAPTURE(color, c.begin[color + 1] - c.begin[color]);
    CHECK(c.begin[color + 1] - c.begin[color] >
          0.5 * static_cast<double>(mesh.tets.size()) / static_cast<double>(colors));
  }
}

TEST_CASE("along the curve neighbors are close together, for any order of the file") {
  TetMesh mesh = make_box(16, 16, 16, {1, 1, 1});
  std::shuffle(mesh.tets.begin(), mesh.tets.end(), std::mt19937(3));
  const auto order = curve_order(mesh.positions, mesh.tets);
  CHECK(std::set<std::uint32_t>(order.begin(), order.end()).size() == mesh.tets.size());
  const auto center = [&](std::uint32_t t) { return mesh.positions[mesh.tets[t][0]]; };
  double along = 0, shuffled = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    along += (center(order[i]) - center(order[i + 1])).norm();
    shuffled += (center(static_cast<std::uint32_t>(i)) - center(static_cast<std::uint32_t>(i + 1))).norm();
  }
  CAPTURE(along / static_cast<double>(order.size()), shuffled / static_cast<double>(order.size()));
  CHECK(along < 0.2 * shuffled);
  CHECK(curve_order(mesh.positions, {}).empty());
}

TEST_CASE("colors are balanced: none is tiny") {
  const TetMesh mesh = make_box(12, 6, 6, {2, 1, 1});
  const Coloring c = color_tets(mesh.tets, std::vector<char>(mesh.positions.size(), 0), file_order(mesh.tets));
  const double mean = static_cast<double>(mesh.tets.size()) / c.color_count();
  for (std::size_t color = 0; color < c.color_count(); ++color) {
    CAPTURE(color, c.begin[color + 1] - c.begin[color], mean);
    CHECK(c.begin[color + 1] - c.begin[color] > 0.3 * mean);
  }
}

TEST_CASE("more than 64 colors around one vertex") {
  std::vector<Tet> fan;
  for (std::uint32_t i = 0; i < 150; ++i) fan.push_back({0, 3 * i + 1, 3 * i + 2, 3 * i + 3});
  const Coloring c = color_tets(fan, std::vector<char>(451, 0), file_order(fan));
  CHECK(c.color_count() == 150);
}

TEST_CASE("all vertices constrained: one color; no tets: none") {
  const TetMesh mesh = make_box(2, 2, 2, {1, 1, 1});
  CHECK(color_tets(mesh.tets, std::vector<char>(mesh.positions.size(), 1), file_order(mesh.tets)).color_count() == 1);
  CHECK(color_tets({}, {}, {}).color_count() == 0);
}
