// The options of fascia render.
#include "app/command_line.h"
#include "app/commands.h"

namespace fascia {

void add_render(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command = *program.add_subcommand("render", "a picture or a video without a window");
  add_common(command, *options);
  add_size(command, options->width, options->height);
  command.add_option("--out", options->out, "the picture after the last step")->type_name("FILE.png");
  command.add_option("--video", options->video, "every frame, through ffmpeg")->type_name("FILE.mp4");
  command.add_option("--fps", options->fps, "frames per second of the video")->check(CLI::Range(1.0, 1000.0))->capture_default_str();
  command.add_option("--samples", options->samples, "samples per pixel")->check(CLI::Range(1, 16))->capture_default_str();
  command.add_option("--color", options->color, "what colors the tissue, as the scene key display.color: none, region, strain, von_mises, displacement, ...");
  command.add_flag("--wireframe", options->wireframe, "draw the surface's edges");
  command.add_flag("--ui", options->panels, "draw the window's panels too");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return command_render(*options); };
  });
}

}  // namespace fascia
