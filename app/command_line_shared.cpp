// Options that several commands have.
#include <cstdio>

#include "app/command_line.h"

namespace fascia {

void add_size(CLI::App& command, int& width, int& height) {
  command
      .add_option_function<std::string>(
          "--size",
          [&](const std::string& text) {
            char end = 0;
            if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) != 2 || width < 16 || height < 16 ||
                width > 16384 || height > 16384)
              throw CLI::ValidationError("--size", text + " is not a size; expected WIDTHxHEIGHT, 16x16 to 16384x16384");
          },
          "picture size in pixels")
      ->type_name("WxH")
      ->default_str(std::to_string(width) + "x" + std::to_string(height));
}

void add_graphics(CLI::App& command, CommonOptions& options) {
  command.add_option("--context", options.context, "where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "window", "egl", "osmesa"}))
      ->capture_default_str();
  command.add_option("--loads", options.loads, "how kernels read buffers; auto: texel on software renderers, ssbo on GPUs")
      ->check(CLI::IsMember({"auto", "ssbo", "texel"}))
      ->capture_default_str();
  command.add_option("--data-dir", options.data_dir, "folder that holds shaders/ and assets/")->type_name("DIR");
  command.add_flag("--quiet", options.quiet, "say nothing but errors");
}

void add_common(CLI::App& command, CommonOptions& options) {
  command.add_option("scene", options.input, "scene (.json) or tetrahedral mesh; default: the shipped liver");
  command.add_option("--set", options.sets, "override a scene value, e.g. solver.iterations=40")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--grab", options.grabs, "one more hand, as in the scene's grabs: \"at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02\"")
      ->type_name("KEY=VALUE;...")
      ->allow_extra_args(false);
  command.add_option("--replay", options.replay, "recorded inputs, with the scene they were made on")->type_name("FILE");
  auto* steps = command.add_option("--steps", options.steps, "steps to simulate")->check(CLI::NonNegativeNumber);
  command.add_option("--time", options.time, "seconds to simulate; default: the scene's duration")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber)
      ->excludes(steps);
  command.add_flag("--static", options.static_equilibrium, "static equilibrium instead of motion");
  command.add_flag("--reference", options.reference, "the double-precision CPU solver instead of the GPU");
  add_graphics(command, options);
}

}  // namespace fascia
