// A context and the project's shaders for tests of GPU passes, once per load path: by storage blocks with the sums of
// graphics cards, on any device; by texels with those of the device.
#pragma once
#include <memory>

#include "gl/program.h"
#include "render/context/context.h"
#include "tests/support/support.h"

namespace fascia::test {

struct Gpu {
  explicit Gpu(gl::LoadPath loads = gl::LoadPath::texel, const std::string& name = context_names().front())
      : context(make_context({name})),
        programs(source_dir() / "shaders", loads,
                 loads == gl::LoadPath::storage ? gl::Sums::in_groups : gl::fitting_sums()) {}
  std::unique_ptr<Context> context;
  gl::ProgramCache programs;
};

}  // namespace fascia::test
