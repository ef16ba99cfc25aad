// fascia render: the same scene, headless: a PNG at the end, a video on the way.
#include <filesystem>
#include <iostream>

#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/headless/headless.h"
#include "app/headless/video_render.h"
#include "app/session/open_input.h"
#include "app/video/frame_sink.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "sim/simulation/divergence.h"

namespace fascia {
namespace {

std::vector<OutputFile> outputs_of(const RenderOptions& options) {
  if (!options.video.empty()) require_frames("--video", options.video);
  const bool pictures = lower_ending(options.video) == ".png";
  return {{"--out", options.out, {".png"}},
          {"--diff", options.difference, {".png"}},
          {"--video", pictures ? "" : options.video, {}}};
}

// The exit code.
int judge(const RenderOptions& options, const Outcome& outcome) {
  if (options.update) {
    for (const std::string& change : update_goldens(outcome, options.goldens()))
      if (!options.quiet) std::cerr << "fascia: " << change << '\n';
    return exit_done;
  }
  if (std::error_code ignored; !options.difference.empty())
    std::filesystem::remove(options.difference, ignored);  // of an earlier run
  const Comparison comparison = compare(outcome, options.goldens(), options.limits);
  for (const Finding& finding : comparison.findings)
    if (!finding.passed || !options.quiet) std::cerr << "fascia: " << finding.text << '\n';
  for (const std::string& reason : comparison.reasons) std::cerr << "fascia: " << reason << '\n';
  if (!options.difference.empty() && comparison.picture)
    write_png(options.difference, *comparison.picture, outcome.provenance);
  return comparison.passed() ? exit_done : exit_failed;
}

}  // namespace

int command_render(const RenderOptions& options) {
  const bool compares = !options.compare.empty() || !options.state.empty();
  if (options.update && !compares)
    throw UsageError("--update", "has no golden to write", "expected --compare GOLDEN.png, --state GOLDEN.csv or both");
  if (options.out.empty() && options.video.empty() && !options.hash && !compares)
    throw UsageError("fascia render", "no output named",
                     "expected --out FILE.png, --video FILE.mp4, --compare GOLDEN.png or several of them");
  if (options.static_equilibrium && !options.video.empty())
    throw UsageError("--static", "has no motion to put into " + options.video, "leave out --video");
  require_steps_or_static(options);
  const std::vector<OutputFile> outputs = outputs_of(options);
  require_outputs(outputs);
  if (options.update)
    require_outputs({{"--compare", options.compare, {".png"}, OutputFile::Takes::all_but_foreign},
                     {"--state", options.state, {".csv"}}});
  std::optional<EndAtOnce> opening(std::in_place);
  Headless headless(options);
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
  std::optional<VideoRender> video;
  if (!options.video.empty()) video.emplace(options, headless);
  headless.run([&] {
    if (video) video->after_step();
  });
  if (!options.static_equilibrium) require_valid(headless.session().simulation);
  if (video) {
    video->finish();
    if (!options.quiet) std::cerr << "fascia: " << options.video << ", " << video->frames() << " frames\n";
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
  }
  return compares ? judge(options, outcome) : exit_done;
}

}  // namespace fascia
