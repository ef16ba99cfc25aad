// The options of fascia render.
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "app/golden/tolerance.h"
#include "base/error.h"
#include "render/supersampler.h"
#include "sim/scene/scene.h"

namespace fascia {
namespace {

CLI::Option* add_tolerance(CLI::App& command, const std::string& name, double& field, const std::string& fallback,
                           const std::string& help) {
  return command
      .add_option_function<std::string>(
          name,
          [&field, name](const std::string& text) {
            try {
              field = parse_tolerance(text, name);
            } catch (const Error& error) {
              throw CLI::ValidationError(error.what());
            }
          },
          help)
      ->type_name("SHARE")
      ->default_str(fallback);
}

void add_comparison(CLI::App& command, RenderOptions& options) {
  CLI::Option* picture =
      command
          .add_option("--compare", options.compare, "a golden picture to compare with; exit code 1 where it differs")
          ->type_name("GOLDEN.png");
  CLI::Option* state = command
                           .add_option("--state", options.state,
                                       "golden positions to compare those reached with, as run --export writes them")
                           ->type_name("GOLDEN.csv");
  add_tolerance(command, "--max-mean", options.limits.mean, "0.5/255",
                "mean difference of color channels that --compare allows")
      ->needs(picture);
  add_tolerance(command, "--max-share", options.limits.share, "0.001",
                "share of pixels that may be off by more than 8/255")
      ->needs(picture);
  add_tolerance(command, "--state-tolerance", options.limits.state, "1e-5",
                "how far a vertex may be from its golden, in sizes of the scene (diagonal of its box at rest)")
      ->needs(state);
  command.add_option("--diff", options.difference, "golden, new picture and difference side by side")
      ->type_name("FILE.png")
      ->needs(picture);
  command.add_flag("--update", options.update, "write the goldens anew and say what changed");
}

}  // namespace

void add_render(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command = *program.add_subcommand("render", "a picture or a video without a window");
  add_common(command, *options);
  add_size(command, options->width, options->height);
  command.add_option("--out", options->out, "the picture after the last step")->type_name("FILE.png");
  auto* video =
      command
          .add_option("--video", options->video,
                      "every frame: .mp4, .webm, .gif and what else ffmpeg writes, or pictures by a pattern such as "
                      "frames/%05d.png; GIF counts in hundredths of a second: take --fps 50, 25 or 20")
          ->type_name("FILE");
  command.add_option("--fps", options->fps, "frames per second of the video")
      ->check(CLI::Range(1.0, 1000.0))
      ->needs(video)
      ->capture_default_str();
  command
      .add_option("--slow", options->slow,
                  "times slower than life: between steps the tissue moves on a smooth path through them")
      ->check(CLI::Range(0.01, 1000.0))
      ->needs(video)
      ->capture_default_str();
  command
      .add_option("--samples", options->samples,
                  "samples per pixel; more than the renderer has are averaged from several pictures")
      ->check(CLI::Range(1, kMostSamples))
      ->capture_default_str();
  command
      .add_option("--camera", options->camera,
                  "follow (a replay's), scene, a scene or replay file that has one, or EYE,TARGET as six numbers")
      ->capture_default_str();
  command.add_flag("--hash", options->hash, "print fingerprints of the last state and of all frames of the video");
  std::vector<std::string> colors;
  for (const ColorBy color : all_colors()) colors.emplace_back(name_of(color));
  add_choice(command, "--color", options->color, colors, "what colors the tissue (scene key display.color)");
  command.add_flag("--wireframe", options->wireframe, "draw the surface's edges");
  command
      .add_option("--split", options->split,
                  "two sides under the same input: as opened, and with these values, such as "
                  "\"solver.method=jacobi;solver.acceleration=none\"")
      ->type_name("KEY=VALUE;...");
  command.add_flag("--ui", options->panels, "draw the window's panels too");
  add_comparison(command, *options);
  add_examples(command,
               {"fascia render liver.json --out shot.png --steps 60 --color von_mises",
                "fascia render liver.json --video liver.mp4 --time 4 --size 1920x1080",
                "fascia render liver.json --steps 30 --compare golden.png --state golden.csv --diff diff.png"},
               "the work failed, or a golden differs");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return command_render(*options); };
  });
}

}  // namespace fascia
