#include <cstring>
#include <random>

#include "render/passes/surface_renderer.h"
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

/// A sphere that is sheared, stretched and perturbed, in numbers that float represents exactly.
test::Shape deformed_sphere(double scale, std::vector<Vector3d>& rest) {
  test::Shape shape = test::sphere({0, 0, 0}, scale, 24);
  rest = shape.positions;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::Matrix3d stretch;
  stretch << 1.4, 0.3, -0.2, 0.1, 0.8, 0.2, -0.3, 0.1, 1.1;
  for (Vector3d& p : shape.positions) {
    p = stretch * p + 0.02 * scale * Vector3d(uniform(random), uniform(random), uniform(random));
    p = p.cast<float>().cast<double>();
    shape.scalars.push_back(static_cast<float>(uniform(random)));
  }
  return shape;
}

}  // namespace

TEST_CASE("normals of a deformed surface agree with double precision, twice the same bits") {
  const auto context = test::each_context();
  const auto path = GENERATE(gl::LoadPath::storage, gl::LoadPath::texel);
  const double scale = GENERATE(5e-4, 1.0, 100.0);
  CAPTURE(gl::name_of(path), scale);
  std::vector<Vector3d> rest;
  const test::Shape shape = deformed_sphere(scale, rest);
  const SurfaceCorners corners = make_surface_corners(shape.triangles, static_cast<std::uint32_t>(rest.size()), rest);
  REQUIRE(corners.vertex.size() == rest.size());  // smooth: corners are vertices, in the order of triangles

  gl::ProgramCache programs(test::source_dir() / "shaders", path);
  SurfaceRenderer renderer(programs, corners);
  const gl::Buffer positions = shape.upload();
  renderer.update(positions);
  const std::vector<float> found = renderer.corner_normals().read<float>();
  const std::vector<float> moved = renderer.corner_positions().read<float>();

  std::vector<Vector3d> expected(rest.size(), Vector3d::Zero());
  const std::vector<Vector3d>& x = shape.positions;
  for (const auto& [a, b, c] : shape.triangles) {
    const Vector3d area = (x[b] - x[a]).cross(x[c] - x[a]);
    for (const std::uint32_t v : {a, b, c}) expected[v] += area;
  }
  double worst = 0;
  for (std::size_t i = 0; i < corners.vertex.size(); ++i) {
    const std::uint32_t v = corners.vertex[i];
    const Vector3d normal(found[4 * i], found[4 * i + 1], found[4 * i + 2]);
    worst = std::max(worst, (normal - expected[v].normalized()).norm());
    REQUIRE(moved[4 * i + 1] == static_cast<float>(x[v].y()));
    REQUIRE(moved[4 * i + 3] == shape.scalars[v]);
  }
  INFO("largest error of a normal " << worst);
  // float32: each cross product is off by up to 2 eps |b| |c|, which the thin triangles at the poles (sine about 0.1)
  // turn into 20 eps of its length; with the sum and the inverse square root less than 1e-5.
  CHECK(worst < 1e-5);

  renderer.update(positions);
  const std::vector<float> again = renderer.corner_normals().read<float>();
  CHECK(std::memcmp(again.data(), found.data(), found.size() * sizeof(float)) == 0);
}

TEST_CASE("a box's normals are its faces', and follow its rotation") {
  const auto context = test::each_context();
  test::Shape shape = test::box({-1, -1, -1}, {1, 1, 1}, 3);
  const SurfaceCorners corners =
      make_surface_corners(shape.triangles, static_cast<std::uint32_t>(shape.positions.size()), shape.positions);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  for (Vector3d& p : shape.positions) p = rotation * p;
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  SurfaceRenderer renderer(programs, corners);
  const gl::Buffer positions = shape.upload();
  renderer.update(positions);
  const std::vector<float> found = renderer.corner_normals().read<float>();
  for (std::size_t i = 0; i < corners.vertex.size(); ++i) {
    const Vector3d at_rest = rotation.transpose() * Vector3d(found[4 * i], found[4 * i + 1], found[4 * i + 2]);
    CAPTURE(i, at_rest.transpose());
    REQUIRE(at_rest.cwiseAbs().maxCoeff() > 1 - 1e-5);  // along an axis
  }
}

TEST_CASE("normals follow a replaced positions buffer") {
  const auto context = test::each_context();
  test::Shape shape = test::box({-1, -1, -1}, {1, 1, 1}, 1);
  const SurfaceCorners corners =
      make_surface_corners(shape.triangles, static_cast<std::uint32_t>(shape.positions.size()), shape.positions);
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  SurfaceRenderer renderer(programs, corners);
  const gl::Buffer first = shape.upload();
  renderer.update(first);
  for (Vector3d& p : shape.positions) p *= 3;
  const gl::Buffer second = shape.upload();
  renderer.update(second);
  CHECK(std::abs(renderer.corner_positions().read<float>()[0]) == 3);
}

}  // namespace fascia
