// The body does not overlap the color bar or the other half of a comparison; pictures without a bar are not changed.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "app/headless/headless.h"
#include "app/overlay/color_bar.h"
#include "app/session/framing.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct Size {
  int width, height;
};

Scene scene_of(const std::string& name, const std::string& color) {
  return open_scene(source_dir() / ("assets/scenes/" + name + ".json"), {"display.color=" + color});
}

/// Columns of the picture in which the body at rest is visible.
Eigen::Vector2d columns(const Session& session, int width, int height) {
  Eigen::Vector2d seen(1e9, -1e9);
  const Model& model = session.simulation.model;
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet)
      if (const auto at = pixel_of(session, model.rest_positions[v], width, height))
        seen = {std::min(seen.x(), at->x()), std::max(seen.y(), at->x())};
  return seen;
}

}  // namespace

TEST_CASE("a frame keeps any body between panels and bar, and does not change pictures without need", "[framing]") {
  for (const Eigen::Vector2d& extent : {Eigen::Vector2d(-1, 1), {-0.9, 1.1}, {-0.4, 0.5}, {-1.25, 0.2}, {-0.2, 1.25}})
    for (const Size size : {Size{800, 600}, {1280, 720}, {640, 480}, {500, 900}, {1000, 1000}, {3840, 1080}})
      for (const double left : {0.0, 120.0, 338.0})
        for (const double right : {0.0, 90.0, 180.0}) {
          if (left + right > 0.9 * size.width) continue;
          const double half = 0.5 * std::min(size.width, size.height);
          CAPTURE(extent.transpose(), size.width, size.height, left, right);
          Camera camera;
          frame_picture(camera, extent, {size.width, size.height, {left, right}});
          const auto column = [&](double seen) {
            return 0.5 * size.width * (1 + camera.middle.x()) + seen * half / camera.reach;
          };
          const double begin = column(extent.x()), end = column(extent.y());
          CAPTURE(camera.middle.x(), camera.reach, begin, end);
          const double middle = 0.5 * (left + size.width);
          const bool clear = middle + extent.y() * half < size.width - right - 0.03 * size.width &&
                             middle + extent.x() * half > left + 0.03 * size.width;
          if ((left == 0 && right == 0) || clear) {
            CHECK(camera.reach == 1);
            CHECK(camera.middle.x() == Approx(left / size.width).margin(1e-12));
          } else {
            CHECK(begin >= left);
            CHECK(end <= size.width - right);
            CHECK(camera.reach >= 1);
          }
        }
}

TEST_CASE("a camera that shows a part of the body shows the same part beside the bar", "[framing]") {
  Camera camera;
  frame_picture(camera, {-7, 9}, {800, 600, {0, 160}});
  CAPTURE(camera.middle.x(), camera.reach);
  CHECK(camera.reach > 1);
  CHECK(camera.reach < 1.4);
  CHECK(0.5 * 800 * (1 + camera.middle.x()) == Approx(320).margin(10));
}

TEST_CASE("a legend at the left edge mirrors one at the right edge", "[framing]") {
  for (const Eigen::Vector2d& extent : {Eigen::Vector2d(-1, 1), {-0.5, 1.6}, {-2, 2}}) {
    Camera right, left;
    frame_picture(right, extent, {800, 600, {0, 160}});
    frame_picture(left, {-extent.y(), -extent.x()}, {800, 600, {.legend_left = 160}});
    CAPTURE(extent.transpose(), right.middle.x(), left.middle.x());
    CHECK(left.middle.x() == Approx(-right.middle.x()).margin(1e-12));
    CHECK(left.reach == Approx(right.reach));
  }
}

TEST_CASE("a comparison with its legend at the left frames both halves alike", "[framing]") {
  const Margins margins{.left = 100, .legend_left = 150};
  const std::array<SplitView::Area, 2> areas = SplitView::areas(1000, margins);
  CHECK(areas[0].x == 100);
  CHECK(areas[0].width == areas[1].width + 150);
  CHECK(areas[1].x + areas[1].width <= 1000);
}

TEST_CASE("rendered bodies do not overlap their color bar", "[framing]") {
  const std::string name = GENERATE("liver", "ligament", "inclusion", "kidney", "cube", "beam");
  const std::string color = GENERATE("largest_stress", "region");
  RenderOptions options;
  static_cast<CommonOptions&>(options) = headless();
  options.input = (source_dir() / "assets/scenes" / (name + ".json")).string();
  options.color = color;
  options.steps = 0;
  options.samples = 1;
  const Size size = GENERATE(Size{800, 600}, Size{1280, 720});
  options.width = size.width;
  options.height = size.height;
  Headless picture(options);
  picture.draw();
  const auto legend =
      legend_box({0, 0, static_cast<float>(size.width), static_cast<float>(size.height)}, picture.session());
  REQUIRE(legend);
  const Eigen::Vector2d seen = columns(picture.session(), size.width, size.height);
  CAPTURE(name, color, size.width, legend->left, seen.transpose());
  CHECK(seen.x() >= 0);
  CHECK(seen.y() <= legend->left);
}

TEST_CASE("a comparison frames the body in both halves alike, beside the bar", "[framing]") {
  const std::string name = GENERATE("liver", "beam", "inclusion");
  const std::string color = GENERATE("none", "von_mises");
  Graphics graphics = open_graphics(headless(), false);
  const Scene scene = scene_of(name, color);
  Session a(graphics, scene, false);
  SplitView split(graphics, a, scene, build_model(scene));
  for (const Size size : {Size{800, 600}, {1280, 720}, {402, 600}})
    for (const Margins margins : {Margins{}, {0, 130}, {180, 0}, {180, 130}}) {
      if (margins.right > 0 && color == "none") continue;
      Framebuffer framebuffer(size.width, size.height, 1);
      split.draw(a, framebuffer, margins, {});
      const std::array<SplitView::Area, 2> areas = SplitView::areas(size.width, margins);
      const Eigen::Vector2d in_a = columns(a, areas[0].width, size.height),
                            in_b = columns(split.b(), areas[1].width, size.height);
      CAPTURE(name, color, size.width, size.height, margins.left, margins.right, areas[0].width, in_a.transpose(),
              in_b.transpose());
      CHECK(areas[1].x + areas[1].width <= size.width);
      CHECK(std::abs(areas[1].width - areas[0].width - margins.right) <= 1);
      CHECK(in_a.x() >= 0);
      CHECK(in_a.y() <= areas[0].width);
      CHECK(in_b.x() == Approx(in_a.x()).margin(0.01));
      CHECK(in_b.y() == Approx(in_a.y()).margin(0.01));
    }
}

TEST_CASE("a body is above what covers the bottom of the picture", "[framing]") {
  Camera camera, alone;
  const Eigen::Vector2d extent{-0.7, 0.7};
  frame_picture(alone, extent, {1280, 720, {}});
  frame_picture(camera, extent, {1280, 720, {0, 0, 180}});
  // A point of the lens' upper and lower edge, in rows from the top
  const auto row = [](const Camera& c, double up) { return 0.5 * 720 * (1 - c.middle.y() - up / c.reach); };
  CAPTURE(camera.middle.transpose(), camera.reach);
  CHECK(row(alone, 1) == Approx(0).margin(1e-9));
  CHECK(row(alone, -1) == Approx(720));
  CHECK(row(camera, 1) == Approx(0).margin(1e-9));
  CHECK(row(camera, -1) == Approx(720 - 180));
  INFO("and beside the panels, where the picture is narrow");
  frame_picture(camera, extent, {800, 600, {338, 0, 165}});
  const double half = 0.5 * (600 - 165), smaller = camera.reach / (600.0 / (600 - 165)),
               middle = 0.5 * 800 * (1 + camera.middle.x());
  CHECK(middle + extent.x() * half / smaller >= 338);
  CHECK(middle + extent.y() * half / smaller <= 800);
}

TEST_CASE("a scene without a camera shows its instruments where the body keeps half of its size", "[framing]") {
  Graphics graphics = open_graphics(headless(), false);
  const auto framed = [&](std::vector<Instrument> instruments) {
    Scene scene = scene_of("cube", "none");
    scene.camera.reset();
    scene.tools.instruments = std::move(instruments);
    return Session(graphics, scene, false).camera;
  };
  const auto at = [](const Eigen::Vector3d& place) {
    return Instrument{"ball", ToolShape(SphereShape{{0, 0, 0}, 0.02}), std::nullopt, {{0, place, {0, 0, 0}, 0}}, false};
  };
  const auto is_in = [](const Camera& camera, const Eigen::Vector3d& place) {
    const Eigen::Vector4f seen = camera.view() * place.homogeneous().cast<float>();
    return seen.head<2>().cwiseAbs().maxCoeff() < -seen.z() * std::tan(camera.fov_deg * std::numbers::pi / 360);
  };
  const Camera alone = framed({});
  const Eigen::Vector3d beside(0.12, 0.15, 0), far(0.3, 1, 0);
  CHECK_FALSE(is_in(alone, beside));
  CHECK(framed({at({0, 0.08, 0})}).eye == alone.eye);  // in view as it is
  CHECK(framed({at(far)}).eye == alone.eye);
  const Camera both = framed({at(far), at(beside)});
  CHECK(is_in(both, beside));
  CHECK((both.eye - both.target).norm() < 2.5 * (alone.eye - alone.target).norm());
}

TEST_CASE("a newly framed body fills the space beside the bar", "[framing]") {
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, scene_of("liver", "von_mises"), false);
  session.camera.zoom(4);
  const Frame frame{1000, 700, {300, 150}};
  const double room = frame.width - frame.margins.left - frame.margins.right;
  frame_picture(session.camera, session.extent, frame);
  session.frame_bodies(1000.0 / 700, {room / 1000, 1});
  frame_picture(session.camera, session.extent, frame);
  const Eigen::Vector2d seen = columns(session, frame.width, frame.height);
  CAPTURE(seen.transpose(), session.camera.reach);
  CHECK(seen.x() >= frame.margins.left);
  CHECK(seen.y() <= frame.width - frame.margins.right);
  CHECK(seen.y() - seen.x() > 0.7 * room);
}
