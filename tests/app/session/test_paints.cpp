// Paints of a scene's materials, and the picture of a scene whose regions have looks of their own.
#include <catch2/catch.hpp>

#include "app/session/session.h"
#include "app/session/shown_look.h"
#include "sim/material/tissue_looks.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;

namespace {

bool has_color(const TissuePaint& paint, const SrgbColor& color) {
  return paint.color == Eigen::Vector3f(color[0], color[1], color[2]);
}

}  // namespace

TEST_CASE("a material without a look has the first one, and its color changes patches and lines alike") {
  Material material;
  CHECK(has_color(paint_of(material), tissue_looks().front().color));
  CHECK_FALSE(paint_of(material).over_corners);
  material.look = find_look("fat");
  const TissuePaint fat = paint_of(material);
  CHECK(has_color(fat, find_look("fat")->color));
  CHECK(fat.wetness == find_look("fat")->wetness);
  material.color = {0.25, 0.5, 0.125};
  const TissuePaint own = paint_of(material);
  CHECK(own.color == Eigen::Vector3f(0.25f, 0.5f, 0.125f));
  CHECK(own.over_corners);
  for (int k = 0; k < 3; ++k)
    CHECK(own.patches[k] / own.color[k] == Approx(std::min(fat.patches[k] / fat.color[k], 1 / own.color[k])));
  CHECK(own.wetness == fat.wetness);
}

TEST_CASE("a region shows its material's color in a cut, also after a change") {
  Graphics graphics = open_graphics(test::headless(), false);
  Session session(graphics, open_scene(test::source_dir() / "assets/scenes/inclusion.json", {"display.color=none"}),
                  false);
  DisplaySettings display = session.display();
  display.section = SectionPlane{{0, 0, 1}, 0};
  session.set_display(display);
  Framebuffer picture(320, 240, 1);
  const auto greens = [&] {
    session.draw(picture);
    const Image image = picture.read();
    long count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i + 1] > image.rgba[i] + 40;
    return count;
  };
  CHECK(greens() == 0);
  std::vector<Material>& materials = session.simulation.model.materials;
  REQUIRE(materials.size() == 2);
  Material tumour = materials[1];
  tumour.color = {0, 0.7, 0};
  session.simulation.set_material(1, tumour);
  const long inside = greens();
  CHECK(inside > 100);
  Material all = materials[0];
  all.color = {0, 0.7, 0};
  session.simulation.set_material(0, all);
  CHECK(greens() > 5 * inside);
  // The same paint everywhere needs no regions.
  all.look = tumour.look;
  session.simulation.set_material(0, all);
  CHECK(greens() > 5 * inside);
}
