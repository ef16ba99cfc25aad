// fascia render: the same scene, headless: a PNG at the end, a video on the way.
#include <cmath>
#include <iostream>

#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/recorder.h"
#include "sim/error.h"

namespace fascia {

int command_render(const RenderOptions& options) {
  if (options.out.empty() && options.video.empty())
    throw Error("fascia render", "no output named", "expected --out FILE.png, --video FILE.mp4 or both");
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
  if (!options.out.empty()) {
    write_png(options.out, headless.draw().read(), headless.provenance());
    if (!options.quiet) std::cerr << "fascia: " << options.out << '\n';
  }
  return interrupted() ? exit_interrupted : exit_done;
}

}  // namespace fascia
