// Options of several commands.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "app/cli/command_line.h"
#include "base/suggest.h"
#include "sim/scene/mesh_frame.h"

namespace fascia {

CLI::Validator at_least(double least) {
  std::ostringstream text;
  text << "a number from " << least << " on";
  return CLI::Validator(
      [least, expected = text.str()](std::string& value) {
        double number = 0;
        const char* const end = value.data() + value.size();
        const auto read = std::from_chars(value.data(), end, number);
        const bool good = read.ec == std::errc{} && read.ptr == end && std::isfinite(number) && number >= least;
        return good ? std::string() : "is " + value + "; expected " + expected;
      },
      "");
}

CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& field,
                        const std::vector<std::string>& choices, const std::string& help) {
  std::string names;
  for (const std::string& choice : choices) names += (names.empty() ? "" : "|") + choice;
  const CLI::Validator is_choice(
      [choices](std::string& value) {
        if (std::find(choices.begin(), choices.end(), value) != choices.end()) return std::string();
        return "is \"" + value + "\"" + perhaps(value, choices) + "; expected one of " + join(choices);
      },
      "");
  return command.add_option(name, field, help)->check(is_choice)->type_name(names);
}

void add_examples(CLI::App& command, const std::vector<std::string>& lines, const std::string& failed) {
  std::string text = lines.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  command.footer(text + "Exit codes: 0 done, 1 " + failed + ", 2 wrong usage, 130 interrupted");
}

void add_size(CLI::App& command, int& width, int& height) {
  command
      .add_option_function<std::string>(
          "--size",
          [&](const std::string& text) {
            char end = 0;
            if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) != 2 || width < 16 || height < 16 ||
                width > 16384 || height > 16384)
              throw CLI::ValidationError("--size",
                                         text + " is not a size; expected WIDTHxHEIGHT, 16x16 to 16384x16384");
          },
          "picture size in pixels")
      ->type_name("WxH")
      ->default_str(std::to_string(width) + "x" + std::to_string(height));
}

void add_quality(CLI::App& command, CommonOptions& options) {
  add_choice(command, "--quality", options.quality, {"auto", "full", "draft"},
             "detail of tissue, soft shadows and smooth edges in pictures; auto: full, but draft in the frames of a "
             "window on software renderers")
      ->capture_default_str();
}

void add_graphics(CLI::App& command, CommonOptions& options) {
  add_choice(command, "--context", options.context, {"auto", "window", "egl", "osmesa"}, "where OpenGL comes from")
      ->capture_default_str();
  command
      .add_option("--device", options.device,
                  "number of the EGL device that computes and draws, of those that fascia info --device lists; without "
                  "it the first GPU, and for a window that of its display")
      ->type_name("N")
      ->check(at_least(0));
  add_choice(command, "--loads", options.loads, {"auto", "ssbo", "texel"},
             "how kernels read buffers; auto: ssbo on GPUs with 14 storage blocks a kernel and more, else texel")
      ->capture_default_str();
  add_choice(
      command, "--kernels", options.kernels, {"auto", "single"},
      "how a step runs on software renderers; auto: many kernels fused into one, which takes longer to compile and "
      "half as long to run; results are the same to the bit")
      ->capture_default_str();
  command.add_option("--data-dir", options.data_dir, "folder that holds shaders/ and assets/")->type_name("DIR");
  command.add_flag("--quiet", options.quiet, "print errors only");
}

void add_mesh_frame(CLI::App& command, std::string& unit, std::string& up) {
  const auto names_of = [](const auto& choices) {
    std::vector<std::string> names;
    for (const auto choice : choices) names.emplace_back(name_of(choice));
    return names;
  };
  add_choice(command, "--unit", unit, names_of(kLengthUnits),
             "unit of the mesh's coordinates (scene key unit); default: guessed for a mesh on its own");
  add_choice(command, "--up", up, names_of(kUpAxes),
             "axis of the mesh that points up (scene key up); default: guessed for a mesh on its own");
}

std::vector<std::string> mesh_frame_sets(const std::string& unit, const std::string& up) {
  std::vector<std::string> sets;
  if (!unit.empty()) sets.push_back("unit=" + unit);
  if (!up.empty()) sets.push_back("up=" + up);
  return sets;
}

void add_common(CLI::App& command, CommonOptions& options) {
  command
      .add_option("scene", options.input,
                  "scene (.json, also the name of a shipped one), tetrahedral mesh, surface or replay (.fascia); - is "
                  "a scene on standard input, with paths from the working folder; default: the shipped liver")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--set", options.sets, "override a scene value, e.g. solver.iterations=40")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_mesh_frame(command, options.unit, options.up);
  command
      .add_option("--grab", options.grabs,
                  "one more grab, as in the scene's grabs: "
                  "\"at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02\"")
      ->type_name("KEY=VALUE;...")
      ->allow_extra_args(false);
  command
      .add_option("--instrument", options.instruments,
                  "one more instrument, as in the scene's instruments: "
                  "\"name=probe;shape=sphere;radius=0.01;from=0,0.1,0;to=0,0.02,0;duration=1\"")
      ->type_name("KEY=VALUE;...")
      ->allow_extra_args(false);
  command.add_option("--replay", options.replay, "recorded inputs, with the scene they were made on")
      ->type_name("FILE.fascia");
  auto* steps = command.add_option("--steps", options.steps, "steps to simulate")->check(at_least(0));
  command.add_option("--time", options.time, "seconds to simulate; default: the scene's duration")
      ->type_name("SECONDS")
      ->check(at_least(0))
      ->excludes(steps);
  command.add_flag("--static", options.static_equilibrium, "static equilibrium instead of motion");
  command.add_flag("--reference", options.reference, "the double-precision CPU solver instead of the GPU");
  add_graphics(command, options);
}

}  // namespace fascia
