#include "app/bench/beam.h"

#include <Eigen/Geometry>
#include <cmath>

#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 1, kWidth = 0.25;       // [m]
constexpr double kBending = 1.7, kTwisting = 1.7;  // factors of x in curvature and twist at x [1/m^2]

// Center line of the bent beam: integral of (cos, sin) of its angle from 0 to x, by the midpoint rule.
Vector3d center_line(double x) {
  constexpr int kParts = 200;
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < kParts; ++i) {
    const double s = x * (i + 0.5) / kParts, angle = 0.5 * kBending * s * s;
    sum += x / kParts * Vector3d(std::cos(angle), std::sin(angle), 0);
  }
  return sum;
}

}  // namespace

Scene beam_scene(const Bench& bench, double young_modulus, const SolverSettings& settings) {
  const Eigen::Vector3i cells = bench.full_or_quick(Eigen::Vector3i(24, 6, 6), Eigen::Vector3i(8, 2, 2));
  write_mesh(bench.folder / "beam.msh", make_box(cells.x(), cells.y(), cells.z(), {kLength, kWidth, kWidth}));
  Scene scene;
  scene.file = bench.folder / "beam.json";
  scene.title = "Beam of the benchmark";
  Body body;
  body.name = "beam";
  body.mesh = "beam.msh";
  body.material.young_modulus = young_modulus;
  body.material.poisson_ratio = 0.3;
  body.material.density = 1000;
  body.fixed.push_back(BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}});
  scene.bodies.push_back(body);
  scene.solver = settings;
  return scene;
}

std::vector<std::uint32_t> beam_tip(const Model& model) {
  std::vector<std::uint32_t> tip;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > kLength - 1e-6) tip.push_back(v);
  return tip;
}

double squared_distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += (a[v] - b[v]).squaredNorm();
  return sum;
}

State bent_beam(const Model& model) {
  State state = initial_state(model);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    const Vector3d& rest = model.rest_positions[v];
    const Vector3d axis(0, 0.5 * kWidth, 0.5 * kWidth);
    const Vector3d across(0, rest.y() - axis.y(), rest.z() - axis.z());
    const double half_square = 0.5 * rest.x() * rest.x();
    const Vector3d turned = Eigen::AngleAxisd(kBending * half_square, Vector3d::UnitZ()) *
                            (Eigen::AngleAxisd(kTwisting * half_square, Vector3d::UnitX()) * across);
    state.displacement[v] = float32_of(axis + center_line(rest.x()) + turned - rest);
  }
  for (const std::uint32_t v : model.fixed) state.displacement[v].setZero();
  return state;
}

}  // namespace fascia
