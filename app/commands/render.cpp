// fascia render: renders a scene headless: a PNG at the end, a video during the run.
#include <filesystem>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/output_files.h"
#include "app/cli/picture_preset.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/golden/tolerance.h"
#include "app/headless/nudged_run.h"
#include "app/headless/video_render.h"
#include "app/overlay/legend_file.h"
#include "app/session/open_input.h"
#include "app/session/progress_lines.h"
#include "app/video/frame_sink.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "render/supersampler.h"
#include "sim/scene/scene.h"
#include "sim/simulation/divergence.h"

namespace fascia {
namespace {

std::vector<OutputFile> outputs_of(const RenderOptions& options) {
  if (!options.video.empty()) require_frames("--video", options.video);
  const bool pictures = lower_ending(options.video) == ".png";
  return {{"--out", options.out, {".png"}},
          {"--diff", options.difference, {".png"}},
          {"--video", pictures ? "" : options.video, {}},
          {"--legend-out", options.legend_out, {".svg", ".pdf"}}};
}

// Returns the exit code.
int judge(const RenderOptions& options, const Outcome& outcome) {
  if (options.update) {
    for (const std::string& change : renew_goldens(options, outcome))
      if (!options.quiet) std::cerr << "fascia: " << change << '\n';
    return exit_done;
  }
  if (std::error_code ignored; !options.difference.empty())
    std::filesystem::remove(options.difference, ignored);  // from an earlier run
  const Comparison comparison = compare(outcome, options.goldens(), options.limits);
  for (const Finding& finding : comparison.findings)
    if (!finding.passed || !options.quiet) std::cerr << "fascia: " << finding.text << '\n';
  for (const std::string& reason : comparison.reasons) std::cerr << "fascia: " << reason << '\n';
  if (!options.difference.empty() && comparison.picture)
    write_png(options.difference, *comparison.picture, outcome.provenance);
  return comparison.passed() ? exit_done : exit_failed;
}

// Why the colors of the error are all the same and their bar has no numbers; empty if they are as they should be.
std::string note_of_error(const RenderOptions& options, const Session& session) {
  const Simulation& simulation = session.simulation;
  if (session.display().color != ColorBy::error || (!simulation.uses_reference() && simulation.gpu()->has_step()))
    return "";
  return std::string("display.color=error has no colors: it compares the last step with an exact one, and ") +
         (options.static_equilibrium    ? "--static takes no steps"
          : simulation.uses_reference() ? "the steps of --reference are exact"
                                        : "no step was taken");
}

int render_input(const RenderOptions& options) {
  const bool compares = !options.compare.empty() || !options.state.empty();
  if (options.update && !compares)
    throw UsageError("--update", "has no golden to write", "expected --compare GOLDEN.png, --state GOLDEN.csv or both");
  if (options.out.empty() && options.video.empty() && !options.hash && !compares)
    throw UsageError("fascia render", "no output named",
                     "expected --out FILE.png, --video FILE.mp4, --compare GOLDEN.png or several of them");
  if (!options.turntable.empty()) parse_turntable(options.turntable);  // a typing mistake is reported before opening
  if (!options.legend_out.empty() && options.out.empty())
    throw UsageError("--legend-out", "has no picture to explain", "expected --out FILE.png beside it");
  require_steps_or_static(options);
  const std::vector<OutputFile> outputs = outputs_of(options);
  require_outputs(outputs);
  if (options.update)
    require_outputs({{"--compare", options.compare, {".png"}, OutputFile::Takes::all_but_foreign},
                     {"--state", options.state, {".csv"}}});
  std::optional<EndAtOnce> opening(std::in_place);
  std::optional<Headless> opened(std::in_place, options);
  Headless& headless = *opened;
  opening.reset();
  std::vector<std::filesystem::path> inputs = input_files(headless.session().simulation.scene);
  inputs.insert(inputs.end(), {options.compare, options.state});
  if (const std::vector<std::string> missing = missing_goldens(options.goldens());
      !options.update && !missing.empty()) {
    for (const std::string& line : missing) std::cerr << "fascia: " << line << '\n';
    return exit_failed;
  }
  require_outputs(outputs, inputs);
  if (!options.video.empty() && headless.session().display().background == Background::transparent)
    throw Error("--video", "has no transparency", "expected another display.background");
  if (options.static_equilibrium && !options.video.empty() && headless.camera_seconds() == 0)
    throw UsageError("--static", "has no motion to put into " + options.video,
                     "expected --turntable SECONDS, camera.keys, or no --video");
  if (!options.legend_out.empty() && !has_legend_file(headless.session()))
    throw UsageError("--legend-out", "has no colors to explain", "expected --color, or the scene key display.color");
  std::optional<VideoRender> video;
  if (!options.video.empty()) video.emplace(options, headless);
  const Progress progress = options.quiet ? Progress() : stepping_progress(headless.session().simulation.scene.file);
  headless.run([&] {
    if (video) video->after_step();
    if (headless.steps() > 0)
      report(progress, static_cast<double>(headless.step()) / static_cast<double>(headless.steps()), "Simulating");
  });
  if (!options.static_equilibrium) require_valid(headless.session().simulation);
  if (const std::string note = note_of_error(options, headless.session()); !note.empty() && !options.quiet)
    std::cerr << "fascia: " << note << '\n';
  if (video) {
    video->finish(progress);
    if (!options.quiet) std::cerr << "fascia: " << options.video << ", " << video->frames() << " frames\n";
    if (const std::string note = video->note_of_range(); !note.empty() && !options.quiet)
      std::cerr << "fascia: " << note << '\n';
  }
  if (options.hash) {
    std::cout << "state " << hash_text(state_hash(headless.session().simulation.state())) << '\n';
    if (video) std::cout << "frames " << hash_text(video->hash()) << ' ' << video->frames() << '\n';
  }
  if (interrupted() || (options.out.empty() && !compares)) return interrupted() ? exit_interrupted : exit_done;
  const Outcome outcome = headless.outcome();
  if (!options.out.empty()) {
    write_png(options.out, outcome.picture, outcome.provenance);
    if (!options.quiet) std::cerr << "fascia: " << options.out << '\n';
    if (!options.legend_out.empty()) write_legend(options.legend_out, headless.session());
  }
  video.reset();
  opened.reset();  // goldens take another run, with another context
  return compares ? judge(options, outcome) : exit_done;
}

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
  add_tolerance(command, "--contact-tolerance", options.limits.contact, "1e-3",
                "how far the force of a tool may be from its golden, over the largest golden force")
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
  CLI::Option* samples =
      command
          .add_option("--samples", options->samples,
                      "samples per pixel; more than the renderer has are averaged from several pictures")
          ->check(CLI::Range(1, kMostSamples))
          ->capture_default_str();
  command
      .add_option("--camera", options->camera,
                  "follow (a replay's), scene, a scene or replay file that has one, or EYE,TARGET as six numbers")
      ->capture_default_str();
  command
      .add_option("--turntable", options->turntable,
                  "the camera circles its target: one turn in so many seconds of the video, 8s, or so many degrees in "
                  "the whole video, 360deg")
      ->type_name("8s|360deg")
      ->needs(video);
  std::vector<std::string> presets;
  for (const PicturePreset& preset : picture_presets()) presets.emplace_back(preset.name);
  add_choice(command, "--preset", options->preset, presets,
             "display values and samples for a purpose, which --set and other options override");
  command.add_option("--legend-out", options->legend_out, "the legend of --out alone, as SVG or PDF")
      ->type_name("FILE.svg");
  command.add_flag("--hash", options->hash, "print fingerprints of the last state and of all frames of the video");
  std::vector<std::string> colors;
  for (const ColorBy color : all_colors()) colors.emplace_back(name_of(color));
  add_choice(command, "--color", options->color, colors, "what colors the tissue (scene key display.color)");
  add_quality(command, *options);
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
  command.callback([&invocation, options, samples] {
    options->command_line = invocation.command_line;
    for (const PicturePreset& preset : picture_presets())
      if (preset.name == options->preset && samples->empty()) options->samples = preset.samples;
    invocation.run = [options] { return render_input(*options); };
  });
}

}  // namespace fascia
