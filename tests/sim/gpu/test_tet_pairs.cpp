// Where pairs of tets leave what vertices gather.
#include <catch2/catch.hpp>

#include "sim/gpu/gauss_seidel.h"
#include "sim/locality.h"
#include "tests/sim/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model beam() {
  return make_model(make_box(5, 3, 3, {0.25, 0.1, 0.1}), {2e4, 0.3, 1000, 0, MaterialModel::signed_st_venant_kirchhoff},
                    [](const Vector3d& x) { return x.x() < 1e-9; });
}

// Every corner has a slot of its own, among those of its vertex. Returns the number of slots.
std::size_t check_slots(const SimBuffers& buffers) {
  const auto tets = buffers.tet_vertices.read<Tet>(), slots = buffers.pair_slots.read<Tet>();
  const auto fifth = buffers.fifth_slot.read<std::uint32_t>(), begin = buffers.slot_begin.read<std::uint32_t>();
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
    const Tet& a = tets[two ? 2 * i : buffers.pair_count + i];
    for (int k = 0; k < 4; ++k) use(a[k], slots[i][k]);
    if (!two) continue;
    const Tet& b = tets[2 * i + 1];
    REQUIRE((b[0] == a[0] && b[1] == a[2] && b[2] == a[1] && b[3] != a[3]));
    use(b[3], fifth[i]);
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
