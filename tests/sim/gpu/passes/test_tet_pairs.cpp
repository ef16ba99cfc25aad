// The slots in which pairs of tets store values that vertices gather.
#include <Eigen/LU>
#include <bit>
#include <catch2/catch.hpp>

#include "sim/gpu/methods/gauss_seidel.h"
#include "sim/ordering/morton_order.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model beam() {
  return make_model(make_box(5, 3, 3, {0.25, 0.1, 0.1}), {2e4, 0.3, 1000, 0, MaterialModel::signed_st_venant_kirchhoff},
                    [](const Vector3d& x) { return x.x() < 1e-9; });
}

// Checks that every corner has its own slot among those of its vertex. Returns the number of slots.
std::size_t check_slots(const SimBuffers& buffers) {
  const auto tets = buffers.tet_vertices.read<Tet>(), slots = buffers.pair_slots.read<Tet>();
  const auto fifth = buffers.pair_fifth.read<Tet>();
  const auto begin = buffers.slot_begin.read<std::uint32_t>();
  REQUIRE(slots.size() == buffers.pair_and_single_count());
  REQUIRE(fifth.size() == slots.size());
  std::vector<int> used(begin.back(), 0);
  const auto use = [&](std::uint32_t vertex, std::uint32_t slot) {
    CAPTURE(vertex, slot);
    REQUIRE(slot >= begin[vertex]);
    REQUIRE(slot < begin[vertex + 1]);
    ++used[slot];
  };
  for (std::uint32_t i = 0; i < slots.size(); ++i) {
    const bool two = i < buffers.pair_count;
    const Tet& a = tets[i];
    for (int k = 0; k < 4; ++k) use(a[k], slots[i][k]);
    if (!two) continue;
    const Tet& b = tets[slots.size() + i];
    REQUIRE((b[0] == a[0] && b[1] == a[2] && b[2] == a[1] && b[3] != a[3]));
    CHECK(fifth[i][0] == b[3]);
    use(b[3], fifth[i][1]);
  }
  CHECK(used == std::vector<int>(begin.back(), 1));
  CHECK(buffers.correction.bytes() == 16 * begin.back());
  return begin.back();
}

}  // namespace

TEST_CASE("pairs of tets have five slots, one at each corner's vertex", "[gpu]") {
  Gpu gpu;
  const Model model = beam();
  SimBuffers buffers(model);
  CHECK(buffers.pair_count == model.tets.size() / 2);
  CHECK(check_slots(buffers) == 5 * model.tets.size() / 2);
}

TEST_CASE("a second tet's shape functions are computed from the first one's, even beside slivers", "[gpu]") {
  Gpu gpu;
  TetMesh mesh = make_box(5, 3, 3, {0.25, 0.1, 0.1});
  // Moves inner vertices nearly into a face of a tet around them: heights of a thousandth.
  std::size_t flat = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); t += 23) {
    const Tet& tet = mesh.tets[t];
    const std::vector<Vector3d> before = mesh.positions;
    const Vector3d &p = mesh.positions[tet[1]], &q = mesh.positions[tet[2]], &r = mesh.positions[tet[3]];
    const Vector3d center = (p + q + r) / 3;
    mesh.positions[tet[0]] = center + 0.001 * (mesh.positions[tet[0]] - center);
    const auto upright = [&](const Tet& other) {
      const std::vector<Vector3d>& x = mesh.positions;
      return (x[other[1]] - x[other[0]]).cross(x[other[2]] - x[other[0]]).dot(x[other[3]] - x[other[0]]) > 1e-12;
    };
    if (std::all_of(mesh.tets.begin(), mesh.tets.end(), upright))
      ++flat;
    else
      mesh.positions = before;
  }
  REQUIRE(flat > 3);
  const Model model =
      make_model(mesh, {2e4, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff}, [](const Vector3d&) { return false; });
  SimBuffers buffers(model);
  REQUIRE(buffers.pair_count > 100);
  const auto tets = buffers.tet_vertices.read<Tet>(), fifth = buffers.pair_fifth.read<Tet>();
  const auto rows = buffers.tet_shape.read<shared::vec4>();
  const auto row = [&](std::size_t t, std::size_t k) {
    return Eigen::Vector3f(rows[3 * t + k].x, rows[3 * t + k].y, rows[3 * t + k].z);
  };
  for (std::size_t i = 0; i < buffers.pair_count; ++i) {
    const std::size_t a = i, b = buffers.pair_and_single_count() + i;
    const float c = std::bit_cast<float>(fifth[i][2]), volume = std::bit_cast<float>(fifth[i][3]);
    const Eigen::Vector3f x = row(a, 2),
                          made[3] = {row(a, 1) + rows[3 * a + 2].w * x, row(a, 0) + rows[3 * a + 1].w * x, -c * x};
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = model.rest_positions[tets[b][k + 1]] - model.rest_positions[tets[b][0]];
    const Eigen::Matrix3d exact = edges.inverse();
    CAPTURE(i, c, exact.norm());
    REQUIRE(c > 0.999f);
    REQUIRE(volume == Approx(edges.determinant() / 6).epsilon(1e-6));
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k, made[k].transpose(), exact.row(k));
      REQUIRE((made[k].cast<double>() - exact.row(k).transpose()).norm() < 5e-7 * exact.norm());
    }
  }
}

TEST_CASE("an order by color has single tets, and back", "[gpu]") {
  Gpu gpu;
  const Model model = beam();
  SimBuffers buffers(model);
  const GaussSeidelMethod by_color(model, buffers, 0);
  CHECK(buffers.pair_and_single_count() == model.tets.size());
  CHECK(check_slots(buffers) == 4 * model.tets.size());
  buffers.set_tet_order(model, paired_tets(model));
  CHECK(check_slots(buffers) == 5 * model.tets.size() / 2);
}
