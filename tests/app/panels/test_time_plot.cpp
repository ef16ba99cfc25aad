// Charts over time as pictures.
#include <catch2/catch.hpp>

#include "app/ui/audit.h"
#include "tests/app/panels/desk.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct PlotDesk : Desk {
  Image plotted() {
    Image picture;
    for (int frame = 0; frame < 3; ++frame) {  // until sizes that depend on the frame before have settled
      Framebuffer framebuffer(1280, 720, 1);
      overlay.draw_headless(session, framebuffer, true, std::nullopt, {}, [&] {
        Requests requests;
        draw_plots(session.simulation, state, requests);
      });
      picture = framebuffer.read();
    }
    return picture;
  }
};

Sample sample_at(double time, double share) {
  Sample sample;
  sample.time = time;
  sample.reaction = {0, share * std::sin(6 * time), 0};
  sample.probe = {0.01 * time, -0.02 * share * std::sin(3 * time), 0};
  return sample;
}

double different_pixels(const Image& a, const Image& b) { return difference(a, b).share * a.width * a.height; }

}  // namespace

TEST_CASE("a measured curve can be fitted from the plots, and its result is shown", "[plots]") {
  PlotDesk desk;
  Plots& plots = desk.state.plots;
  plots.shown = true;
  for (int i = 0; i <= 200; ++i) plots.history.add(sample_at(0.01 * i, 1));
  const Image without = desk.plotted();
  for (int i = 0; i <= 20; ++i) plots.measured.push_back(sample_at(0.1 * i, 0.8));
  const Image choosing = desk.plotted();
  plots.fit.keys = {"materials.default.young_modulus", "materials.default.damping"};
  plots.fit.line = "The fit has ended";
  plots.fit.found = {{"materials.default.young_modulus", 12345, 12000, 12700}, {"materials.default.damping", 0.01}};
  plots.fit.found[1].low = plots.fit.found[1].high = std::nan("");
  const Image found = desk.plotted();
  CHECK(different_pixels(without, choosing) > 1000);
  CHECK(different_pixels(choosing, found) > 1000);
  CHECK(ui::unexplained().empty());
}

TEST_CASE("measured samples are drawn beside the simulated ones, and charts without any stay as they are", "[plots]") {
  PlotDesk desk;
  WindowState& state = desk.state;
  state.plots.shown = true;
  for (int i = 0; i <= 200; ++i) state.plots.history.add(sample_at(0.01 * i, 1));
  const Image without = desk.plotted();
  CHECK(different_pixels(without, desk.plotted()) == 0);
  for (int i = 0; i <= 20; ++i) {
    Sample sample = sample_at(0.1 * i, 0.8);
    sample.kinetic = sample.elastic = sample.gravitational = Sample::kUnknown;
    sample.volume_ratio = Sample::kUnknown;
    sample.grab = Eigen::Vector3d::Constant(Sample::kUnknown);
    state.plots.measured.push_back(sample);
  }
  const Image with = desk.plotted();
  const double drawn = different_pixels(without, with);
  CAPTURE(drawn);
  CHECK(drawn > 1000);
  // The far neighbor of a narrow view is drawn up to the edge only.
  state.plots.measured.back().time = 1e6;
  state.plots.span = 0.1;
  CHECK(different_pixels(desk.plotted(), with) > 0);
}
