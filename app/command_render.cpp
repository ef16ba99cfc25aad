// fascia render: the same scene, headless: a PNG at the end, a video on the way.
#include <cmath>
#include <iostream>

#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/recorder.h"
#include "sim/error.h"

namespace fascia {
namespace {

// The exit code.
int judge(const RenderOptions& options, const Outcome& outcome) {
  if (options.update) {
    for (const std::string& change : update_goldens(outcome, options.goldens()))
      if (!options.quiet) std::cerr << "fascia: " << change << '\n';
    return exit_done;
  }
  const Comparison comparison = compare(outcome, options.goldens(), options.limits);
  for (const Finding& finding : comparison.findings)
    if (!finding.passed || !options.quiet) std::cerr << "fascia: " << finding.text << '\n';
  for (const std::string& reason : comparison.reasons) std::cerr << "fascia: " << reason << '\n';
  if (!options.difference.empty() && comparison.picture) write_png(options.difference, *comparison.picture, outcome.provenance);
  return comparison.passed() ? exit_done : exit_failed;
}

}  // namespace

int command_render(const RenderOptions& options) {
  const bool compares = !options.compare.empty() || !options.state.empty();
  if (options.update && !compares) throw Error("--update", "has no golden to write", "expected --compare GOLDEN.png, --state GOLDEN.csv or both");
  if (options.out.empty() && options.video.empty() && !compares)
    throw Error("fascia render", "no output named", "expected --out FILE.png, --video FILE.mp4, --compare GOLDEN.png or several of them");
  if (options.static_equilibrium && !options.video.empty())
    throw Error("--static", "has no motion to put into " + options.video, "leave out --video");
  Headless headless(options);
  if (!options.video.empty() && headless.session().display().background == Background::transparent)
    throw Error("--video", "has no transparency", "expected another display.background");
  std::optional<Recorder> recorder;
  std::vector<std::uint8_t> pixels(std::size_t{4} * options.width * options.height);
  long frame = 0;
  if (!options.video.empty()) recorder.emplace(options.video, options.width, options.height, options.fps, headless.provenance());
  const double time_step = headless.session().simulation.scene.solver.time_step;
  // Frame k shows the step nearest to k / fps, so that a video runs at the speed of life whatever the time step.
  headless.run([&] {
    while (recorder && std::lround(frame / options.fps / time_step) <= headless.step() &&
           (headless.step() < headless.steps() || frame < std::lround(headless.steps() * time_step * options.fps))) {
      headless.draw().read_into(pixels.data());
      recorder->write(pixels);
      ++frame;
    }
  });
  if (recorder) {
    recorder->finish();
    if (!options.quiet) std::cerr << "fascia: " << options.video << ", " << recorder->frames() << " frames\n";
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
