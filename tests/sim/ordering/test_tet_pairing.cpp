// Tets in pairs that share a face.
#include "sim/ordering/tet_pairing.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <random>

#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"

using namespace fascia;

namespace {

std::vector<std::uint32_t> unchanged_order(const std::vector<Tet>& tets) {
  std::vector<std::uint32_t> order(tets.size());
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

// Whether the order of a tet's corners has the same orientation, among its 24 orders.
bool same_orientation(const Tet& tet, const Tet& turned) {
  int inversions = 0;
  std::array<std::ptrdiff_t, 4> place{};
  for (int a = 0; a < 4; ++a) place[a] = std::find(tet.begin(), tet.end(), turned[a]) - tet.begin();
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) inversions += place[a] > place[b];
  return inversions % 2 == 0;
}

void check_pairs(const std::vector<Tet>& tets, const std::vector<std::uint32_t>& order, const TetPairing& pairing) {
  std::vector<std::uint32_t> wanted = order, got = pairing.order;
  std::sort(wanted.begin(), wanted.end());
  std::sort(got.begin(), got.end());
  REQUIRE(got == wanted);
  REQUIRE(2 * pairing.pair_count <= order.size());
  for (std::size_t i = 0; i < pairing.pair_count; ++i) {
    const Tet &first = tets[pairing.order[i]], &second = tets[pairing.order[pairing.second_begin() + i]];
    Tet a = first, b = second;
    CAPTURE(i, first, second);
    REQUIRE(align_at_face(a, b));
    REQUIRE(std::is_permutation(a.begin(), a.end(), first.begin()));
    REQUIRE(std::is_permutation(b.begin(), b.end(), second.begin()));
    REQUIRE(same_orientation(first, a));
    REQUIRE(same_orientation(second, b));
    REQUIRE((a[0] == b[0] && a[1] == b[2] && a[2] == b[1] && a[3] != b[3]));
  }
}

}  // namespace

TEST_CASE("all but a few tets of a mesh find a partner across a face") {
  const std::filesystem::path meshes = std::filesystem::path(FASCIA_SOURCE_DIR) / "assets/meshes";
  for (const char* name : {"cube.msh", "beam.msh", "inclusion.msh", "liver.msh"}) {
    const std::vector<Tet> tets = read_mesh(meshes / name).mesh.tets;
    const TetPairing pairing = pair_tets(tets, unchanged_order(tets));
    check_pairs(tets, unchanged_order(tets), pairing);
    const double single = 1 - 2.0 * pairing.pair_count / static_cast<double>(tets.size());
    CAPTURE(name, single);
    CHECK(single < 0.01);  // 0.0004 to 0.004
  }
}

TEST_CASE("an odd tet stays single, between the first and the second ones of pairs, and unlisted tets are ignored") {
  const std::vector<Tet> tets = make_box(1, 1, 1, {1, 1, 1}).tets;
  REQUIRE(tets.size() == 6);  // a ring around the diagonal
  CHECK(pair_tets(tets, unchanged_order(tets)).pair_count == 3);
  const std::vector<std::uint32_t> some{4, 2, 0, 1, 3};
  const TetPairing pairing = pair_tets(tets, some);
  check_pairs(tets, some, pairing);
  CHECK(pairing.pair_count == 2);
  CHECK(pairing.second_begin() == 3);
  CHECK(pair_tets(tets, {5}).order == std::vector<std::uint32_t>{5});
  CHECK(pair_tets(tets, {}).order.empty());
}

TEST_CASE("the order of pairs is the given order") {
  const std::vector<Tet> tets = make_box(8, 8, 8, {1, 1, 1}).tets;
  const TetPairing pairing = pair_tets(tets, unchanged_order(tets));
  for (std::size_t i = 1; i < pairing.pair_count; ++i) REQUIRE(pairing.order[i - 1] < pairing.order[i]);
  std::vector<std::uint32_t> shuffled = unchanged_order(tets);
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  check_pairs(tets, shuffled, pair_tets(tets, shuffled));
}

TEST_CASE("tets on one side of a face, or three at one, are not a pair") {
  Tet a{0, 1, 2, 3}, same_side{0, 1, 2, 4}, apart{5, 6, 7, 8};
  const Tet before = a;
  CHECK_FALSE(align_at_face(a, same_side));
  CHECK_FALSE(align_at_face(a, apart));
  Tet twin = a;
  CHECK_FALSE(align_at_face(a, twin));
  CHECK(a == before);
  const std::vector<Tet> overlapping{{0, 1, 2, 3}, {0, 1, 2, 4}}, three{{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 2, 1, 5}};
  CHECK(pair_tets(overlapping, {0, 1}).pair_count == 0);
  CHECK(pair_tets(three, {0, 1, 2}).pair_count == 0);
  CHECK(pair_tets({three[0], three[1]}, {0, 1}).pair_count == 1);
}
