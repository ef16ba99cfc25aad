// Small surfaces and a scene with them, for the tests that draw.
#pragma once
#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "render/passes/shadow_map.h"
#include "render/scene_renderer.h"
#include "render/view/frame_uniforms.h"
#include "tests/gl/gl_support.h"

namespace fascia::test {

struct Shape {
  std::vector<Eigen::Vector3d> positions;
  std::vector<float> scalars;  // empty: 0
  std::vector<std::array<std::uint32_t, 3>> triangles;

  gl::Buffer upload() const {
    std::vector<float> data;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (int k = 0; k < 3; ++k) data.push_back(static_cast<float>(positions[i][k]));
      data.push_back(scalars.empty() ? 0.0f : scalars[i]);
    }
    return gl::Buffer("positions", data);
  }
};

/// `rings` from pole to pole, outward.
inline Shape sphere(const Eigen::Vector3d& center, double radius, int rings) {
  Shape shape;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < (i % rings == 0 ? 1 : around); ++j) {
      const double theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * j / around;
      shape.positions.push_back(center + radius * Eigen::Vector3d(std::sin(theta) * std::sin(phi), std::cos(theta),
                                                                  std::sin(theta) * std::cos(phi)));
    }
  }
  const auto at = [&](int i, int j) {
    if (i == 0) return 0u;
    if (i == rings) return static_cast<std::uint32_t>(shape.positions.size() - 1);
    return static_cast<std::uint32_t>(1 + (i - 1) * around + j % around);
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i > 0) shape.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i < rings - 1) shape.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return shape;
}

/// `cells` along each edge, vertices shared between faces, outward.
inline Shape box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int cells) {
  Shape shape;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, fresh] = known.emplace(p, static_cast<std::uint32_t>(shape.positions.size()));
    if (fresh) {
      const Eigen::Array3d share = Eigen::Array3d(p[0], p[1], p[2]) / cells;
      shape.positions.emplace_back(low.array() + (high - low).array() * share);
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, cells}) {
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = j + v;
            return vertex(p);
          };
          const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}})
            shape.triangles.push_back(side ? std::array{p, q, r} : std::array{p, r, q});
        }
      }
    }
  }
  return shape;
}

/// All inputs of one picture except a context.
struct Scene {
  Shape shape;
  Camera camera;
  Look look;
  std::vector<std::uint32_t> marked, grabbed;
  std::vector<std::array<std::uint32_t, 4>> tets;  // of the shape's vertices
  std::vector<std::uint32_t> tet_region, triangle_region;
  bool within_surface = false;        // as TetView's
  std::vector<std::uint32_t> colors;  // of the triangles' corners
  std::vector<TissuePaint> paints{TissuePaint{}};
  std::vector<Eigen::Vector3d> rest;  // positions at rest; empty: those of the shape
  std::optional<GrabArrow> grab;
  RigidSurface rigid;
  bool creases = true;
  int width = 320, height = 240, samples = 1;

  explicit Scene(Shape drawn) : shape(std::move(drawn)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : shape.positions) box.extend(p);
    look.center = box.center();
    look.radius = box.diagonal().norm() / 2;
    camera.frame(box.min(), box.max());
    camera.fit(box.min(), box.max(), double(width) / height);
  }

  Image draw(gl::LoadPath path = gl::LoadPath::texel) const {
    gl::ProgramCache programs(source_dir() / "shaders", path);
    const std::span<const Eigen::Vector3d> at_rest = rest.empty() ? shape.positions : rest;
    SceneRenderer renderer(programs, shape.triangles, static_cast<std::uint32_t>(shape.positions.size()), marked,
                           creases ? at_rest : std::span<const Eigen::Vector3d>(), colors);
    renderer.set_paints(paints);
    renderer.set_grabbed(grabbed);
    renderer.set_tets({tets, tet_region, within_surface});
    renderer.set_regions(triangle_region);
    renderer.set_rigid(rigid);
    const gl::Buffer positions = shape.upload();
    const Framebuffer target(width, height, samples);
    renderer.draw({&positions}, camera, look, {grab ? &*grab : nullptr, grab ? std::size_t{1} : 0}, target);
    target.resolve();
    const Image image = target.read();
    CHECK(gl::GetError() == GL_NO_ERROR);
    return image;
  }

  /// The position of a point in the picture [pixels from the top left].
  Eigen::Vector2d pixel_of(const Eigen::Vector3d& point) const {
    const Eigen::Matrix4d matrix =
        (camera.projection(double(width) / height, look.radius) * camera.view()).cast<double>();
    const Eigen::Vector3d ndc = (matrix * point.homogeneous()).hnormalized();
    return {(ndc.x() + 1) / 2 * width, (1 - ndc.y()) / 2 * height};
  }
};

/// Color of the pixel that contains this position, 0 to 1.
inline Eigen::Vector3d color_at(const Image& image, double x, double y) {
  REQUIRE((x >= 0 && y >= 0 && x < image.width && y < image.height));
  const std::uint8_t* p = image.rgba.data() + 4 * (static_cast<int>(y) * image.width + static_cast<int>(x));
  return Eigen::Vector3d(p[0], p[1], p[2]) / 255;
}
inline Eigen::Vector3d color_at(const Image& image, const Eigen::Vector2d& place) {
  return color_at(image, place.x(), place.y());
}

inline Eigen::Vector3d toward_light(const Look& look) {
  FrameUniforms frame;
  ShadowMap::aim(look, frame);
  return frame.light.head<3>().cast<double>();
}

}  // namespace fascia::test
