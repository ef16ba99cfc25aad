// Where a static solve stops on the way of its tools: nowhere, unless they end deep in tissue.
#include "sim/tool/tool_approach.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

constexpr double kBallRadius = 0.01, kTissueSize = 0.1;

// Comes down from y = 0.1 in the first second, and goes to `end` in the second one; the tissue is below y = 0.
struct Ball {
  std::vector<Tool> tools;

  explicit Ball(double end) {
    SceneTools scene;
    scene.instruments.push_back({"ball", ToolShape(SphereShape{{0, 0, 0}, kBallRadius}), std::nullopt, {{}}, false});
    scene.instruments.back().path = {
        {0, {0, 0.1, 0}, {0, 0, 0}}, {1, {0, -0.03, 0}, {0, 0, 0}}, {2, {0, end, 0}, {0, 0, 0}}};
    tools = tools_of(scene);
  }
  double height(double time) const { return motion_on_paths(tools, 0, time).to[0].pose.origin.y(); }
  std::vector<double> times() const {
    return approach_times(
        tools, {kBallRadius}, 0, 2, kTissueSize,
        [&](double from, double to) { return motion_on_paths(tools, from, to); },
        [](std::size_t, const ToolPlace& place) { return (kBallRadius - place.pose.origin.y()) / kBallRadius; });
  }
};

}  // namespace

TEST_CASE("a tool that ends beside the tissue, or hardly in it, goes there at once") {
  for (const double end : {0.1, 0.01, 0.001}) CHECK(Ball(end).times() == std::vector<double>{2});
}

TEST_CASE("a tool that ends deep in the tissue comes from where it last was clear, by half of its radius at most") {
  for (const double end : {-0.03, -0.05}) {
    const Ball ball(end);
    const std::vector<double> times = ball.times();
    CAPTURE(end, times);
    REQUIRE(times.size() > 4);
    CHECK(times.back() == 2);
    CHECK(ball.height(times.front()) >= kBallRadius);
    CHECK(ball.height(times[1]) < kBallRadius);
    for (std::size_t k = 1; k < times.size(); ++k)
      CHECK(std::abs(ball.height(times[k]) - ball.height(times[k - 1])) <= 0.5 * kBallRadius + 1e-12);
  }
}
