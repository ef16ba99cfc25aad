// The context and the shader programs of a command.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "app/session/software_threads.h"
#include "gl/program.h"
#include "render/context/context.h"
#include "render/view/quality.h"

namespace fascia {

struct Graphics {
  std::filesystem::path data_dir;
  std::unique_ptr<Context> context;
  std::unique_ptr<gl::ProgramCache> programs;
  Quality live, still;  // of pictures in a window's frames, and of all others
};

/// Creates the context that the options request. On software renderers the number of worker threads is set first
/// (LP_NUM_THREADS, unless the user set it); it cannot be changed later.
Graphics open_graphics(const CommonOptions& options, bool for_view, int width = 16, int height = 16,
                       const Workload& workload = {});

/// "llvmpipe (LLVM 15.0.6, 256 bits) through osmesa, kernels read by texel"
std::string describe(const Graphics& graphics);

/// Prints on stderr, unless quiet, the renderer, if there is one, and the notes about the model. Called after loading,
/// so that a failed load prints only one line.
void announce(const CommonOptions& options, const Graphics& graphics, const std::vector<std::string>& notes);

}  // namespace fascia
