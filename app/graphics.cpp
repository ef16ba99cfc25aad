#include "app/graphics.h"

#include <cstdlib>
#include <iostream>
#include <thread>

#include "app/paths.h"
#include "render/gl/debug.h"

namespace fascia {
namespace {

// llvmpipe: Jacobi's few large dispatches and the rasteriser both gain from every core. Colors are many small dispatches, each of
// which costs 14 to 42 us with worker threads and 0.3 us without.
void choose_software_threads(Method method) {
  const unsigned cores = std::max(1u, std::min(16u, std::thread::hardware_concurrency()));
  setenv("LP_NUM_THREADS", std::to_string(method == Method::gauss_seidel ? 0 : cores).c_str(), 0);
}

// Storage blocks on GPUs; texel fetches on llvmpipe, whose storage reads cost 8 to 12 times as much.
gl::LoadPath choose_loads(const std::string& name) {
  if (name == "ssbo") return gl::LoadPath::storage;
  if (name == "texel") return gl::LoadPath::texel;
  return gl::device().software ? gl::LoadPath::texel : gl::LoadPath::storage;
}

}  // namespace

Graphics open_graphics(const CommonOptions& options, bool for_view, int width, int height, Method method) {
  Graphics graphics;
  graphics.data_dir = find_data_dir(options.data_dir);
  choose_software_threads(method);
  ContextRequest request;
  request.name = options.context;
  request.for_view = for_view;
  request.width = width;
  request.height = height;
  request.debug = std::getenv("FASCIA_GL_DEBUG") != nullptr;
  graphics.context = make_context(request);
  if (request.debug) gl::log_debug_messages([](const std::string& line) { std::cerr << "gl: " << line << '\n'; });
  graphics.programs = std::make_unique<gl::ProgramCache>(graphics.data_dir / "shaders", choose_loads(options.loads));
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
