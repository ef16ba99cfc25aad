#include "app/graphics.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "app/paths.h"
#include "render/gl/debug.h"
#include "sim/error.h"

namespace fascia {
namespace {

// About how many dispatches that do something an iteration of a method has by itself.
std::size_t dispatches_of(Method method) {
  switch (method) {
    case Method::jacobi:
    case Method::mass_splitting: return 3;
    case Method::gauss_seidel: return 32;
    case Method::exact_xpbd: return 6;
    case Method::vertex_descent: return 10;
    case Method::two_level: return 8;
  }
  return 1;
}

// llvmpipe's worker threads cost something where they wait for each other: in a step of fused passes (render/gl/fused_pass.h) after every
// kernel, of which colors make many; else they are woken and awaited in every dispatch, which takes as long as they save on some
// thousands of tets. The rasteriser gains from every core, more than a step loses.
void choose_software_threads(const Workload& workload) {
  constexpr std::size_t kTetsFused = 2000, kTetsOfColors = 8'000, kTetsPerDispatch = 5000;
  const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, 16u);
  const std::size_t least = !workload.fused                           ? kTetsPerDispatch * dispatches_of(workload.method)
                            : workload.method == Method::gauss_seidel ? kTetsOfColors
                                                                      : kTetsFused;
  setenv("LP_NUM_THREADS", std::to_string(workload.drawn || workload.tets >= least ? cores : 0).c_str(), 0);
}

// Storage blocks on GPUs; texel fetches on llvmpipe, whose storage reads cost 8 to 12 times as much, and where kernels may have fewer
// blocks than they read and write buffers: OpenGL 4.3 promises eight.
gl::LoadPath choose_loads(const std::string& name) {
  constexpr int kMostBuffers = 14;  // that any kernel reads or writes
  const int blocks = gl::device().max_compute_storage_blocks;
  const bool enough = blocks >= kMostBuffers;
  if (name == "ssbo" && !enough)
    throw Error("--loads ssbo", gl::device().renderer + " has " + std::to_string(blocks) + " storage blocks in a kernel",
                "expected " + std::to_string(kMostBuffers) + ", or --loads texel");
  if (name == "ssbo") return gl::LoadPath::storage;
  if (name == "texel") return gl::LoadPath::texel;
  return gl::device().software || !enough ? gl::LoadPath::texel : gl::LoadPath::storage;
}

}  // namespace

Workload workload_of(const Scene& scene, const Model& model, bool drawn) {
  return {scene.solver.method, model.tets.size(), drawn, scene.solver.tolerance == 0};
}

Graphics open_graphics(const CommonOptions& options, bool for_view, int width, int height, const Workload& workload) {
  Graphics graphics;
  graphics.data_dir = find_data_dir(options.data_dir);
  choose_software_threads(workload);
  ContextRequest request;
  request.name = options.context;
  request.for_view = for_view;
  request.width = width;
  request.height = height;
  request.debug = std::getenv("FASCIA_GL_DEBUG") != nullptr;
  graphics.context = make_context(request);
  if (request.debug) gl::log_debug_messages([](const std::string& line) { std::cerr << "gl: " << line << '\n'; });
  graphics.programs = std::make_unique<gl::ProgramCache>(graphics.data_dir / "shaders", choose_loads(options.loads));
  graphics.programs->set_fusing(true);
  return graphics;
}

std::string describe(const Graphics& graphics) {
  return std::string(gl::device().renderer) + " through " + graphics.context->name() + ", kernels read by " +
         gl::name_of(graphics.programs->load_path());
}

void announce(const CommonOptions& options, const Graphics& graphics, const std::vector<std::string>& notes) {
  if (options.quiet) return;
  if (graphics.context) std::cerr << "fascia: " << describe(graphics) << '\n';
  for (const std::string& note : notes) std::cerr << "fascia: " << note << '\n';
}

}  // namespace fascia
