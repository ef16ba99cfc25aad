#include "app/session/graphics.h"

#include <cstdlib>
#include <iostream>

#include "app/system/paths.h"
#include "base/error.h"
#include "gl/debug.h"

namespace fascia {
namespace {

gl::LoadPath choose_loads(const std::string& name) {
  const int blocks = gl::device().max_compute_storage_blocks;
  if (name == "ssbo" && blocks < gl::kMostStorageBlocks)
    throw Error("--loads ssbo",
                gl::device().renderer + " has " + std::to_string(blocks) + " storage blocks in a kernel",
                "expected " + std::to_string(gl::kMostStorageBlocks) + ", or --loads texel");
  if (name == "ssbo") return gl::LoadPath::storage;
  if (name == "texel") return gl::LoadPath::texel;
  return gl::fitting_load_path();
}

}  // namespace

Graphics open_graphics(const CommonOptions& options, bool for_view, int width, int height, const Workload& workload) {
  Graphics graphics;
  graphics.data_dir = find_data_dir(options.data_dir);
  const SoftwareThreads threads(workload);
  ContextRequest request;
  request.name = options.context;
  request.device = options.device;
  request.for_view = for_view;
  request.width = width;
  request.height = height;
  request.debug = std::getenv("FASCIA_GL_DEBUG") != nullptr;
  graphics.context = make_context(request);
  if (gl::device().vector_width > 0) threads.spread();
  if (request.debug) gl::log_debug_messages([](const std::string& line) { std::cerr << "gl: " << line << '\n'; });
  graphics.programs = std::make_unique<gl::ProgramCache>(graphics.data_dir / "shaders", choose_loads(options.loads));
  graphics.programs->set_fusing(options.kernels != "single");
  graphics.still = options.quality == "draft" ? kDraftQuality : kFullQuality;
  const bool slow = for_view && gl::device().software && options.quality == "auto";
  graphics.live = slow ? kDraftQuality : graphics.still;
  return graphics;
}

std::string describe(const Graphics& graphics) {
  return std::string(gl::device().renderer) + " through " + graphics.context->name() + ", kernels read by " +
         gl::name_of(graphics.programs->load_path());
}

void announce(const CommonOptions& options, const Graphics& graphics, const std::vector<std::string>& notes) {
  if (options.quiet) return;
  if (graphics.context) std::cerr << "fascia: " << describe(graphics) << '\n';
  if (graphics.context && !graphics.context->passed_over.empty())
    std::cerr << "fascia: no GPU is used: " << graphics.context->passed_over << '\n';
  if (graphics.context && !graphics.context->other_device.empty())
    std::cerr << "fascia: " << graphics.context->other_device << '\n';
  for (const std::string& note : notes) std::cerr << "fascia: " << note << '\n';
}

}  // namespace fascia
