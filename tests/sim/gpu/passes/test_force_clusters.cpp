// The lists by which work groups sum forces of tets. tests/sim/gpu/methods/test_two_level.cpp compares the sums with
// the reference's gradient.
#include <catch2/catch.hpp>
#include <set>

#include "sim/gpu/passes/force_clusters.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t kOfCluster = ForceClusters::kPairs;

Model short_beam(int cells) {
  return make_model(make_box(cells, 3, 3, {0.25, 0.1, 0.1}),
                    {2e4, 0.3, 1000, 0.01, MaterialModel::signed_st_venant_kirchhoff},
                    [](const Vector3d& x) { return x.x() < 1e-9; });
}

}  // namespace

TEST_CASE("every corner of a cluster is in one slot, which is its vertex's", "[gpu]") {
  const int cells = GENERATE(1, 5, 13);  // 54, 270, 702 tets: a cluster that is not full, and several
  Gpu gpu;
  const Model model = short_beam(cells);
  const SimBuffers buffers(model);
  const ForceClusters clusters(buffers);
  const std::uint32_t pairs = buffers.pair_and_single_count();
  REQUIRE(clusters.count() == (pairs + kOfCluster - 1) / kOfCluster);
  const auto lists = clusters.lists().read<std::uint32_t>();
  const auto begin = clusters.slot_begin().read<std::uint32_t>();
  std::vector<int> used(begin.back(), 0);
  std::size_t corners = 0;
  for (std::uint32_t c = 0; c < clusters.count(); ++c) {
    const std::uint32_t list = lists[c], vertices = lists[list], entries = list + 1 + 2 * vertices;
    std::set<std::uint32_t> met;
    for (std::uint32_t v = 0; v < vertices; ++v) {
      const std::uint32_t slot = lists[list + 1 + 2 * v], range = lists[list + 2 + 2 * v];
      ++used[slot];
      for (std::uint32_t k = range & 0xffff; k < (range & 0xffff) + (range >> 16); ++k) {
        const std::uint32_t entry = (lists[entries + k / 3] >> (10 * (k % 3))) & 0x3ff;
        CHECK(met.insert(entry).second);
        const std::uint32_t corner = entry / kOfCluster, pair = kOfCluster * c + entry % kOfCluster;
        REQUIRE(pair < pairs);
        REQUIRE((corner < 4 || pair < buffers.pair_count));
        const std::uint32_t vertex = corner < 4 ? buffers.tets[pair][corner] : buffers.tets[pairs + pair][3];
        CAPTURE(c, v, corner, pair, vertex, slot);
        CHECK(slot >= begin[vertex]);
        CHECK(slot < begin[vertex + 1]);
        ++corners;
      }
    }
  }
  CHECK(used == std::vector<int>(begin.back(), 1));
  CHECK(corners == 5 * buffers.pair_count + 4 * (pairs - buffers.pair_count));
  CHECK(clusters.forces().bytes() == 16 * begin.back());
}

TEST_CASE("listed pairs have a bit in their cluster", "[gpu]") {
  CHECK(clusters_of({}).empty());
  CHECK(clusters_of({0, 31, 32, 63}) == std::vector<std::uint32_t>{0, 0x80000001u, 0x80000001u});
  CHECK(clusters_of({1, 64, 200}) == std::vector<std::uint32_t>{0, 2, 0, 1, 1, 0, 3, 1u << 8, 0});
}

// What a step moves, by the program's own count: see the page on performance.
TEST_CASE("an iteration of a large mesh moves at most 260 bytes for each tet", "[gpu]") {
  Gpu gpu(gl::LoadPath::storage);
  const Model plain = make_model(make_box(64, 16, 16, {1, 0.25, 0.25}), {1e6, 0.3, 1000, 0},
                                 [](const Vector3d& x) { return x.x() < 1e-9; });
  GpuSolver solver(gpu.programs, plain, {});
  const double bytes = solver.bytes_per_iteration() / static_cast<double>(plain.tets.size());
  CAPTURE(plain.tets.size(), bytes);
  CHECK(bytes > 200);  // less would be miscounted
  CHECK(bytes <= 260);
}
