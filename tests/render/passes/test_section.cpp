// Section planes and separate tets, which are drawn from tets instead of the surface.
// Covers: tet_renderer
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::color_at;
using test::Scene;

/// A box from 0 to 1 of cells^3 cells of six tets each, bent by `bend`, seen from `from`. Without ground and shadow, on
/// a transparent backdrop: opaque pixels are tissue.
Scene tet_box(int cells, const Vector3d& from, const std::function<Vector3d(const Vector3d&)>& bend = {}) {
  test::Shape shape;
  std::vector<std::array<std::uint32_t, 4>> tets;
  const auto vertex = [&](int i, int j, int k) {
    return static_cast<std::uint32_t>((i * (cells + 1) + j) * (cells + 1) + k);
  };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      for (int k = 0; k <= cells; ++k) {
        const Vector3d p = Vector3d(i, j, k) / cells;
        shape.positions.push_back(bend ? bend(p) : p);
      }
  std::map<std::array<std::uint32_t, 3>, std::array<std::uint32_t, 3>>
      faces;  // of exactly one tet, by their vertices in order
  for (int c = 0; c < cells * cells * cells; ++c) {
    for (const auto& axes : {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{1, 0, 2},
                             std::array{0, 2, 1}, std::array{2, 1, 0}}) {
      std::array<int, 3> at{c / (cells * cells), c / cells % cells, c % cells};
      std::array<std::uint32_t, 4> tet;
      for (std::size_t n = 0; n < 4; ++n) {
        tet[n] = vertex(at[0], at[1], at[2]);
        if (n < 3) ++at[static_cast<std::size_t>(axes[n])];
      }
      const bool odd = (axes[1] + 3 - axes[0]) % 3 != 1;
      if (odd) std::swap(tet[2], tet[3]);
      tets.push_back(tet);
      for (const auto& f : {std::array{1, 2, 3}, std::array{0, 3, 2}, std::array{0, 1, 3}, std::array{0, 2, 1}}) {
        const std::array face{tet[static_cast<std::size_t>(f[0])], tet[static_cast<std::size_t>(f[1])],
                              tet[static_cast<std::size_t>(f[2])]};
        auto key = face;
        std::sort(key.begin(), key.end());
        if (!faces.emplace(key, face).second) faces.erase(key);
      }
    }
  }
  for (const auto& [key, face] : faces) shape.triangles.push_back(face);
  Scene scene(shape);
  scene.tets = tets;
  scene.tet_region.assign(tets.size(), 0);
  scene.camera.target = scene.look.center;
  scene.camera.eye = scene.look.center + 3 * from.normalized();
  scene.look.ground = scene.look.shadow = false;
  scene.look.backdrop = Backdrop::transparent;
  return scene;
}

int alpha_at(const Image& image, int x, int y) {
  return image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3];
}

/// Pixels that one picture covers and the other does not.
int coverage_difference(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) count += (alpha_at(a, x, y) > 127) != (alpha_at(b, x, y) > 127);
  return count;
}

}  // namespace

TEST_CASE("render: a section of any bent body is closed, without cracks, in the colors of the heat map") {
  const auto context = test::each_context();
  const double bend = GENERATE(0.0, 0.35);
  const auto bent = [=](const Vector3d& p) {
    return Vector3d(p.x() + bend * std::sin(3 * p.z()), p.y() + bend * p.x() * p.x(), p.z() + bend * p.y() * p.x());
  };
  Scene scene = tet_box(5, {0.1, 0.15, 1}, bent);
  for (const Vector3d& p : scene.shape.positions) scene.shape.scalars.push_back(static_cast<float>(p.x()));
  scene.look.heat_map = true;
  scene.look.range = {0, 1};
  scene.look.section = SectionCut{{0, 0, 1}, 0.47f};
  const Image image = scene.draw();
  int inside = 0, on_plane = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (alpha_at(image, x, y) == 0) continue;
      ++inside;
      const Ray ray = scene.camera.ray(x + 0.5, y + 0.5, image.width, image.height);
      const Vector3d hit = ray.origin + ray.direction * ((0.47 - ray.origin.z()) / ray.direction.z());
      const Vector3d expected = heat_color(static_cast<float>(hit.x())).cast<double>();
      // The plane is in front of all remaining tissue: a ray that hits something else first hits a side wall, outside
      // the cut.
      on_plane += (color_at(image, x, y) - expected).cwiseAbs().maxCoeff() < 2.5 / 255;
    }
  }
  CAPTURE(bend, inside, on_plane);
  CHECK(inside > 5000);
  CHECK(on_plane > 0.8 * inside);
  // There are no holes: along every row, all pixels between the first and the last pixel of the cut belong to it.
  for (int y = 0; y < image.height; ++y) {
    int first = -1, last = -1, count = 0;
    for (int x = 0; x < image.width; ++x) {
      if (alpha_at(image, x, y) == 0) continue;
      if (first < 0) first = x;
      last = x;
      ++count;
    }
    CAPTURE(y, first, last);
    if (first >= 0) CHECK(count == last - first + 1);
  }
}

TEST_CASE("render: a section omits exactly the part beyond the plane") {
  const auto context = test::each_context();
  Scene scene = tet_box(4, {1, 0.4, 0.6});
  const Image whole = scene.draw();
  scene.look.section = SectionCut{{1, 0, 0}, 1.01f};  // in front of everything
  CHECK(scene.draw().rgba == whole.rgba);
  scene.look.section = SectionCut{{1, 0, 0}, -0.01f};  // behind everything
  const Image none = scene.draw();
  CHECK(coverage_difference(none, Image{none.width, none.height, std::vector<std::uint8_t>(none.rgba.size(), 0)}) == 0);
  scene.look.section = SectionCut{{1, 0, 0}, 0.5f};  // through a layer of vertices
  const Image half = scene.draw();
  const Vector2d kept = scene.pixel_of({0.5, 0.5, 0.5}), gone = scene.pixel_of({1, 0.02, 0.02});
  CHECK(alpha_at(half, static_cast<int>(kept.x()), static_cast<int>(kept.y())) == 255);
  CHECK(alpha_at(half, static_cast<int>(gone.x()), static_cast<int>(gone.y())) == 0);
  scene.marked = {static_cast<std::uint32_t>(scene.shape.positions.size() - 1)};  // (1, 1, 1), nearest to the eye
  scene.look.section.reset();
  CHECK(scene.draw().rgba != whole.rgba);
  scene.look.section = SectionCut{{1, 0, 0}, 0.5f};
  CHECK(scene.draw().rgba == half.rgba);
}

TEST_CASE("render: the cut of a closed surface ends where the surface does, wherever its tets end") {
  const auto context = test::each_context();
  // Tets from 0 to 1 in x and y; the surface, two overlapping shells, from 0.3 to 1.3: left of 0.3 there are only tets,
  // right of 1 only surface.
  Scene scene = tet_box(4, {0.05, 0.05, 1});
  scene.creases = false;
  scene.shape.triangles.clear();
  for (const double low : {0.3, 0.5}) {
    const test::Shape shell = test::box({low, 0.1, 0.1}, {low + 0.8, 0.9, 0.9}, 2);
    const auto first = static_cast<std::uint32_t>(scene.shape.positions.size());
    scene.shape.positions.insert(scene.shape.positions.end(), shell.positions.begin(), shell.positions.end());
    for (const auto& t : shell.triangles) scene.shape.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for (const Vector3d& p : scene.shape.positions) scene.shape.scalars.push_back(static_cast<float>(p.x()));
  scene.within_surface = true;
  scene.samples = GENERATE(1, 4);
  scene.look.heat_map = true;
  scene.look.section = SectionCut{{0, 0, 1}, 0.5f};
  const Image image = scene.draw();
  const auto at = [&](double x) { return scene.pixel_of({x, 0.5, 0.5}); };
  const auto is_heat = [&](double x) {
    return (color_at(image, at(x)) - heat_color(static_cast<float>(x)).cast<double>()).cwiseAbs().maxCoeff() <
           3.0 / 255;
  };
  CAPTURE(scene.samples, color_at(image, at(0.15)).transpose(), color_at(image, at(0.4)).transpose(),
          color_at(image, at(1.15)).transpose());
  CHECK(alpha_at(image, int(at(0.15).x()), int(at(0.15).y())) == 0);
  CHECK(is_heat(0.4));                                                         // one shell
  CHECK(is_heat(0.8));                                                         // both
  CHECK(color_at(image, at(1.15)).x() > 1.2 * color_at(image, at(1.15)).z());  // plain tissue
  CHECK(alpha_at(image, int(at(1.35).x()), int(at(1.35).y())) == 0);
}

TEST_CASE("render: edges of tets on a section, and none across their quadrilaterals") {
  const auto context = test::each_context();
  Scene scene = tet_box(2, {0, 0, 1});
  scene.width = 960;  // so that lines are a pixel wide
  scene.height = 720;
  scene.look.section = SectionCut{{0, 0, 1}, 0.25f};  // halfway through a layer of cells
  const Image plain = scene.draw();
  scene.look.wireframe = true;
  const Image wire = scene.draw();
  const auto darker = [&](double x, double y) {
    const Vector2d place = scene.pixel_of({x, y, 0.25});
    return color_at(wire, place).sum() < 0.8 * color_at(plain, place).sum();
  };
  CHECK(darker(0.5, 0.3));            // between cells
  CHECK(darker(0.35, 0.35));          // the cell's diagonal face
  CHECK_FALSE(darker(0.1, 0.05));     // inside a triangle
  CHECK_FALSE(darker(0.375, 0.125));  // where both diagonals of a quadrilateral would be
}

TEST_CASE("render: separate tets fill the surface, and gaps open when they shrink") {
  const auto context = test::each_context();
  Scene scene = tet_box(3, {0.7, 0.5, 1});
  const Image surface = scene.draw();
  scene.look.tets = TetSpread{1, 0};
  const Image together = scene.draw();
  CHECK(coverage_difference(together, surface) == 0);
  scene.look.tets = TetSpread{0.5f, 0};
  CHECK(coverage_difference(scene.draw(), surface) > 200);
  // Twice as far apart and as large: the tets of the hull cover about the area of the hull's picture at twice the size.
  scene.look.tets = TetSpread{1, 1};
  int apart = 0, covered = 0;
  const Image spread = scene.draw();
  for (int y = 0; y < spread.height; ++y)
    for (int x = 0; x < spread.width; ++x) {
      apart += alpha_at(spread, x, y) > 0;
      covered += alpha_at(surface, x, y) > 0;
    }
  CAPTURE(apart, covered);
  CHECK(apart > 1.3 * covered);
  // A section omits whole tets: none with a plane behind, all with one in front.
  scene.look.tets = TetSpread{1, 0};
  scene.look.section = SectionCut{{0, 0, 1}, 1.5f};
  CHECK(scene.draw().rgba == together.rgba);
  scene.look.section = SectionCut{{0, 0, 1}, 0.5f};
  CHECK(coverage_difference(scene.draw(), together) > 200);
}

TEST_CASE("render: regions have their colors on the surface, on sections and on tets") {
  const auto context = test::each_context();
  Scene scene = tet_box(4, {0, 0, 1});
  for (std::size_t t = 0; t < scene.tets.size(); ++t) {
    double x = 0;
    for (const std::uint32_t v : scene.tets[t]) x += scene.shape.positions[v].x() / 4;
    scene.tet_region[t] = x < 0.5 ? 0 : 1;
  }
  for (const auto& triangle : scene.shape.triangles)
    scene.triangle_region.push_back(
        (scene.shape.positions[triangle[0]] + scene.shape.positions[triangle[1]] + scene.shape.positions[triangle[2]])
                        .x() /
                    3 <
                0.5
            ? 0
            : 1);
  scene.look.regions = true;
  scene.look.wireframe = GENERATE(false, true);
  scene.colors.assign(3 * scene.shape.triangles.size(), 0xff00ff00);  // hidden by the regions
  const auto check = [&](const char* what, double depth) {
    const Image image = scene.draw();
    for (const unsigned n : {0u, 1u}) {
      const Vector3d color = color_at(image, scene.pixel_of({n == 0 ? 0.25 : 0.75, 0.45, depth})),
                     own = region_color(n).cast<double>();
      CAPTURE(what, n, color.transpose(), own.transpose());
      CHECK((color.normalized() - own.normalized()).norm() < 0.25);
    }
  };
  check("surface", 1);
  scene.look.section = SectionCut{{0, 0, 1}, 0.6f};
  check("section", 0.6);
  scene.look.section.reset();
  scene.look.tets = TetSpread{1, 0};
  check("tets", 1);
}

}  // namespace fascia
