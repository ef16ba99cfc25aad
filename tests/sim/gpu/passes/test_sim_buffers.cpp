#include "sim/gpu/passes/sim_buffers.h"

#include <catch2/catch.hpp>

#include "sim/mesh/mesh_generate.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using shared::vec4;

// The fourth number is the inverse mass in the stage, 0 of held vertices. Where it was lost when bodies were moved as
// wholes, a stage that was solved again moved nothing.
TEST_CASE("vertices that are moved within a stage stay held or free", "[gpu]") {
  test::Gpu gpu;
  const Model model =
      test::make_model(make_box(2, 1, 1, {0.2, 0.1, 0.1}), Material{}, [](const Vector3d& x) { return x.x() < 1e-9; });
  SimBuffers buffers(model);
  std::vector<vec4> in_stage(buffers.vertex_count);
  for (std::uint32_t i = 0; i < buffers.vertex_count; ++i) in_stage[i] = {9, 9, 9, i % 3 == 0 ? 0.0f : 0.1f * i};
  buffers.displacement.upload(0, in_stage.size() * sizeof(vec4), in_stage.data());
  std::vector<Vector3d> u;
  for (std::uint32_t v = 0; v < buffers.vertex_count; ++v) u.emplace_back(0.25 * v, -0.5 * v, 1);
  buffers.upload_displacements(u, buffers.displacement.read<shared::vec4>());
  const std::vector<vec4> moved = buffers.displacement.read<vec4>();
  for (std::uint32_t i = 0; i < buffers.vertex_count; ++i) {
    const Vector3d& wanted = u[buffers.placement.vertex[i]];
    CAPTURE(i, moved[i].x, moved[i].y, moved[i].z, moved[i].w, wanted.transpose(), in_stage[i].w);
    CHECK(Vector3d(moved[i].x, moved[i].y, moved[i].z) == wanted);
    CHECK(moved[i].w == in_stage[i].w);
  }
}

}  // namespace
}  // namespace fascia
