// The command line of fascia, and the one place where errors end: a line on stderr and exit code 1 (2 for wrong usage).
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "sim/error.h"

namespace {

using namespace fascia;

void parse_size(CLI::App* command, int& width, int& height) {
  command
      ->add_option_function<std::string>(
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

void add_graphics(CLI::App* command, CommonOptions& o) {
  command->add_option("--context", o.context, "where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "window", "egl", "osmesa"}))
      ->capture_default_str();
  command->add_option("--loads", o.loads, "how kernels read buffers; auto: texel on software renderers, ssbo on GPUs")
      ->check(CLI::IsMember({"auto", "ssbo", "texel"}))
      ->capture_default_str();
  command->add_option("--data-dir", o.data_dir, "folder that holds shaders/ and assets/")->type_name("DIR");
  command->add_flag("--quiet", o.quiet, "say nothing but errors");
}

void add_common(CLI::App* command, CommonOptions& o) {
  command->add_option("scene", o.input, "scene (.json) or tetrahedral mesh; default: the shipped liver");
  command->add_option("--set", o.sets, "override a scene value, e.g. solver.iterations=40")->type_name("KEY=VALUE")->allow_extra_args(false);
  command->add_option("--replay", o.replay, "recorded inputs, with the scene they were made on")->type_name("FILE");
  auto* steps = command->add_option("--steps", o.steps, "steps to simulate")->check(CLI::NonNegativeNumber);
  command->add_option("--time", o.time, "seconds to simulate; default: the scene's duration")->type_name("SECONDS")->check(CLI::NonNegativeNumber)->excludes(steps);
  command->add_flag("--static", o.static_equilibrium, "static equilibrium instead of motion");
  command->add_flag("--reference", o.reference, "the double-precision CPU solver instead of the GPU");
  add_graphics(command, o);
}

int run(int argc, char** argv) {
  std::string command_line = "fascia";
  for (int i = 1; i < argc; ++i) command_line += std::string(" ") + argv[i];

  CLI::App app{"fascia: interactive soft tissue on the GPU. SI units everywhere. Files and keys: see README.md"};
  app.set_version_flag("--version", std::string("fascia ") + FASCIA_VERSION);
  app.require_subcommand(0, 1);
  ViewOptions view;
  RenderOptions render;
  RunOptions simulate;
  BenchOptions figures;
  InfoOptions info;
  ConvertOptions convert;

  const auto add_view = [&](CLI::App* command) {
    add_common(command, view);
    parse_size(command, view.width, view.height);
    command->add_option("--samples", view.samples, "samples per pixel")->check(CLI::Range(1, 16))->default_str("4, on software renderers 1");
    command->add_option("--export", view.export_path, "the state when the window closes: .vtu, .csv, .msh or .obj")->type_name("FILE");
    command->add_option("--stats", view.stats, "numbers about the run, when the window closes")->type_name("FILE.json");
  };
  add_view(&app);
  CLI::App* view_command = app.add_subcommand("view", "the window (the default command)");
  add_view(view_command);

  CLI::App* render_command = app.add_subcommand("render", "a picture or a video without a window");
  add_common(render_command, render);
  parse_size(render_command, render.width, render.height);
  render_command->add_option("--out", render.out, "the picture after the last step")->type_name("FILE.png");
  render_command->add_option("--video", render.video, "every frame, through ffmpeg")->type_name("FILE.mp4");
  render_command->add_option("--fps", render.fps, "frames per second of the video")->check(CLI::Range(1.0, 1000.0))->capture_default_str();
  render_command->add_option("--samples", render.samples, "samples per pixel")->check(CLI::Range(1, 16))->capture_default_str();
  render_command->add_option("--color", render.color, "heat map: none, strain, von_mises or error (scene key display.color)");
  render_command->add_flag("--wireframe", render.wireframe, "draw the surface's edges");
  render_command->add_flag("--ui", render.panels, "draw the window's panels too");

  CLI::App* run_command = app.add_subcommand("run", "simulate and draw nothing");
  add_common(run_command, simulate);
  run_command->add_option("--export", simulate.export_path, "the state after the last step: .vtu, .csv, .msh or .obj")->type_name("FILE");
  run_command->add_option("--every", simulate.every, "export every K-th step as numbered files")->type_name("K")->check(CLI::PositiveNumber);
  run_command->add_option("--stats", simulate.stats, "numbers about the run")->type_name("FILE.json");
  run_command->add_flag("--error", simulate.error, "compare the last step with the exact one, by the reference solver");

  CLI::App* bench_command = app.add_subcommand("bench", "measurements as tables, charts and pictures");
  bench_command->require_subcommand(1);
  CLI::App* figures_command = bench_command->add_subcommand("figures", "the figures of the poster, and what colorings cost");
  figures_command->add_option("--out", figures.out, "folder for the files, made if missing")->type_name("DIR")->required();
  figures_command->add_flag("--quick", figures.quick, "small meshes, few iterations: the same files in less time, the numbers worth little");
  parse_size(figures_command, figures.width, figures.height);
  add_graphics(figures_command, figures);
  BenchOptions accuracy;
  bool fresh = false;
  CLI::App* accuracy_command =
      bench_command->add_subcommand("accuracy", "error against iterations and time, for every method and acceleration");
  accuracy_command->add_option("--out", accuracy.out, "folder for the files, made if missing; what it holds is not measured again")
      ->type_name("DIR")
      ->required();
  accuracy_command->add_flag("--quick", accuracy.quick, "three small cases, for a first look");
  accuracy_command->add_flag("--fresh", fresh, "measure again what the folder holds");
  add_graphics(accuracy_command, accuracy);

  BenchOptions speed, skip;
  std::string against;
  CLI::App* speed_command = bench_command->add_subcommand("speed", "what steps cost, from 500 to a million tets, for every method and acceleration");
  speed_command->add_option("--out", speed.out, "folder for the tables, made if missing")->type_name("DIR")->required();
  speed_command->add_flag("--quick", speed.quick, "small meshes, few pairs");
  speed_command->add_option("--against", against, "an earlier speed.csv: the ratios, and exit code 1 where something became slower beyond the noise")
      ->type_name("FILE.csv");
  parse_size(speed_command, speed.width, speed.height);
  add_graphics(speed_command, speed);
  CLI::App* skip_command = bench_command->add_subcommand("skip", "what features cost: never had, switched off, on; exit code 1 if off costs anything");
  skip_command->add_option("--out", skip.out, "folder for the table, made if missing")->type_name("DIR")->required();
  skip_command->add_flag("--quick", skip.quick, "a small mesh, few repetitions");
  add_graphics(skip_command, skip);

  BenchOptions stress;
  stress.width = 640;
  stress.height = 360;
  std::string only, model = name_of(Material().model);
  std::vector<std::string> models;
  for (const MaterialModel m : material_models()) models.push_back(name_of(m));
  CLI::App* stress_command = app.add_subcommand("stress", "the torture table: what no pair of method and acceleration may break at");
  stress_command->add_option("--out", stress.out, "folder for the table, its summary, and a replay and a picture of every failure")
      ->type_name("DIR")
      ->required();
  stress_command->add_flag("--quick", stress.quick, "small meshes");
  stress_command->add_option("--only", only, "cases whose group/case/method + acceleration has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  stress_command->add_option("--model", model, "material model of all bodies")->check(CLI::IsMember(models))->capture_default_str();
  parse_size(stress_command, stress.width, stress.height);
  add_graphics(stress_command, stress);

  BenchOptions soak;
  long soak_steps = 100000;
  std::vector<std::string> soak_inputs;
  CLI::App* soak_command = app.add_subcommand("soak", "scenes that are grabbed and let go for very long, twice: what drifts, what grows");
  soak_command->add_option("scenes", soak_inputs, "scenes (.json) or tetrahedral meshes; default: three shipped ones");
  soak_command->add_option("--out", soak.out, "folder for the table")->type_name("DIR")->required();
  soak_command->add_option("--steps", soak_steps, "of every run")->check(CLI::Range(2400l, 1000000000l))->capture_default_str();
  add_graphics(soak_command, soak);

  CLI::App* info_command = app.add_subcommand("info", "mesh doctor: sizes, materials, defects");
  info_command->add_option("scene", info.input, "scene (.json) or tetrahedral mesh")->required();
  info_command->add_option("--set", info.sets, "override a scene value")->type_name("KEY=VALUE")->allow_extra_args(false);

  CLI::App* convert_command = app.add_subcommand("convert", "between mesh formats, by the ending of OUT");
  convert_command->add_option("in", convert.in, "mesh to read")->required();
  convert_command->add_option("out", convert.out, "mesh to write: .msh .vtk .vtu .node .mesh")->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_usage;
  }
  catch_interrupts();
  view.command_line = render.command_line = simulate.command_line = command_line;
  if (*render_command) return command_render(render);
  if (*run_command) return command_run(simulate);
  if (*figures_command) return command_bench_figures(figures);
  if (*accuracy_command) return command_bench_accuracy(accuracy, fresh);
  if (*speed_command) return command_bench_speed(speed, against);
  if (*skip_command) return command_bench_skip(skip);
  if (*soak_command) return command_soak(soak, soak_inputs, soak_steps);
  if (*stress_command) return command_stress(stress, only, *find_material_model(model));
  if (*info_command) return command_info(info);
  if (*convert_command) return command_convert(convert);
  return command_view(view);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int exit_code = run(argc, argv);
    if (!std::cout.flush()) throw fascia::Error("standard output", "writing failed", "expected a device that takes data");
    return exit_code;
  } catch (const std::bad_alloc&) {
    std::cerr << "fascia: needs more memory than there is; expected a smaller mesh\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return fascia::exit_failed;
}
