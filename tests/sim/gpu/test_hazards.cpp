// Barriers by need (gl/barriers.h), judged over everything that solvers and pictures do by a watch that knows only
// OpenGL's calls.
#include <catch2/catch.hpp>

#include "render/scene_renderer.h"
#include "tests/support/gpu/barrier_watch.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/gpu/kernel_cases.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// Pictures of a state: as a surface with marks, as wireframe, cut, and as separate tets. The first one is another one
/// with each `turn`, because its barriers serve the others, too.
void draw_every_way(const Model& model, const GpuSolver& solver, gl::ProgramCache& programs, std::size_t turn) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Tet& tet : model.tets) triangles.push_back({tet[0], tet[1], tet[2]});
  const std::vector<std::uint32_t> regions(model.tets.size(), 0), marked{0, 1};
  const auto vertices = static_cast<std::uint32_t>(model.rest_positions.size());
  SceneRenderer renderer(programs, triangles, vertices, marked, model.rest_positions);
  renderer.set_tets({model.tets, regions, false});
  const Framebuffer target(48, 32, 1);
  Camera camera;
  camera.frame({0, 0, 0}, {0.1, 0.1, 0.1});
  Look surface, wireframe, cut, apart;
  surface.radius = wireframe.radius = cut.radius = apart.radius = 0.1;
  wireframe.wireframe = wireframe.heat_map = true;
  cut.section = SectionCut{{1, 0, 0}, -0.05f};
  apart.tets.emplace();
  const std::array<Look, 4> looks{apart, surface, cut, wireframe};
  for (std::size_t k = 0; k < looks.size(); ++k)
    renderer.draw({&solver.positions()}, camera, looks[(turn + k) % looks.size()], {}, target);
}

void run_and_draw(const KernelCase& example, gl::ProgramCache& programs) {
  std::size_t turn = 0;
  run_all(example, programs, [&](const GpuSolver& solver) { draw_every_way(example.model, solver, programs, turn++); });
}

KernelCase case_of(const std::string& name) {
  for (const KernelCase& example : kernel_cases())
    if (example.name == name) return example;
  FAIL("no case " << name);
  return {};
}

constexpr GLbitfield kStorage = GL_SHADER_STORAGE_BARRIER_BIT, kTexel = GL_TEXTURE_FETCH_BARRIER_BIT,
                     kUpdate = GL_BUFFER_UPDATE_BARRIER_BIT, kCommand = GL_COMMAND_BARRIER_BIT,
                     kVertices = GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT;

}  // namespace

TEST_CASE("every access has the barrier that it needs, and none is made without need", "[gpu]") {
  struct Path {
    gl::LoadPath loads;
    bool fused;
  };
  const Path path =
      GENERATE(Path{gl::LoadPath::storage, false}, Path{gl::LoadPath::texel, false}, Path{gl::LoadPath::texel, true});
  CAPTURE(gl::name_of(path.loads), path.fused);
  Gpu gpu(path.loads);
  gpu.programs.set_fusing(path.fused);
  const BarrierWatch watch;
  for (const KernelCase& example : kernel_cases()) {
    // Fused programs take seconds to compile.
    if (path.fused && example.name != "two_level + subspace" && example.name != "gauss_seidel + none") continue;
    run_and_draw(example, gpu.programs);
    CAPTURE(example.name);
    for (const std::string& finding : watch.findings()) FAIL(finding);
  }
  CHECK(watch.needless_bits() == 0);
  CHECK(watch.commands() > (path.fused ? 200 : 10'000));
  CHECK(watch.barriers() < watch.commands());
  const GLbitfield reads = path.loads == gl::LoadPath::storage ? 0 : kTexel;
  CHECK((watch.bits() & ~kTexel) == (kStorage | kUpdate | kVertices | (path.fused ? 0 : kCommand)));
  CHECK((watch.bits() & reads) == reads);
}

TEST_CASE("a barrier without one of its bits is found", "[gpu]") {
  struct Without {
    GLbitfield bit;
    gl::LoadPath loads;
    const char* example;
  };
  const Without without = GENERATE(Without{kStorage, gl::LoadPath::storage, "jacobi + none"},
                                   Without{kStorage, gl::LoadPath::texel, "jacobi + none"},
                                   Without{kTexel, gl::LoadPath::texel, "jacobi + none"},
                                   Without{kUpdate, gl::LoadPath::storage, "jacobi + none"},
                                   Without{kCommand, gl::LoadPath::storage, "jacobi + none, with a tolerance"},
                                   Without{kVertices, gl::LoadPath::storage, "jacobi + none"});
  CAPTURE(without.bit, gl::name_of(without.loads));
  Gpu gpu(without.loads);
  const BarrierWatch watch(without.bit);
  run_and_draw(case_of(without.example), gpu.programs);
  CHECK(!watch.findings().empty());
  for (const std::string& finding : watch.findings())
    CHECK_THAT(finding, Catch::Contains("needs the bit " + std::to_string(without.bit) + " after "));
}
