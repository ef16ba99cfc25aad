// The context and the shader programs that a command works with.
#pragma once
#include <filesystem>
#include <memory>

#include "app/options.h"
#include "render/context.h"
#include "render/gl/program.h"

namespace fascia {

struct Graphics {
  std::filesystem::path data_dir;
  std::unique_ptr<Context> context;
  std::unique_ptr<gl::ProgramCache> programs;
};

/// Makes the context that the options ask for and says which renderer it got (unless quiet). On software renderers the number
/// of rasteriser threads is chosen first (LP_NUM_THREADS, if the user did not set it).
Graphics open_graphics(const CommonOptions& options, bool for_view, int width = 16, int height = 16);

/// "llvmpipe (LLVM 15.0.6, 256 bits) through osmesa, kernels read by texel"
std::string describe(const Graphics& graphics);

}  // namespace fascia
