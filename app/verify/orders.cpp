// Orders of convergence in space, on smooth solutions of linear elasticity, and in time, on the motion of a released
// beam.
#include <cmath>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/elements/quadratic_tet.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"
#include "sim/simulation/errors/time_error.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A solution without body forces, so small that the law is linear. Papkovich and Neuber: 2 mu u = 4 (1 - nu) B -
/// grad(x . B + phi) with harmonic B = (0, 0, g) or 0, and harmonic phi. With B the change of volume varies.
struct Smooth {
  double nu;
  bool with_pressure;

  Vector3d operator()(const Vector3d& p) const {
    // g = sin 2x cos 2y exp(2 sqrt 2 z)
    const double e = std::exp(2 * std::sqrt(2.0) * p.z()), sx = std::sin(2 * p.x()), cx = std::cos(2 * p.x()),
                 sy = std::sin(2 * p.y()), cy = std::cos(2 * p.y());
    const double g = sx * cy * e;
    const Vector3d slope = 2 * Vector3d(cx * cy * e, -sx * sy * e, std::sqrt(2.0) * g);
    return 1e-7 * (with_pressure ? Vector3d((3 - 4 * nu) * g * Vector3d::UnitZ() - p.z() * slope) : slope);
  }
  Matrix3d strain(const Vector3d& p) const {
    constexpr double kStep = 1e-4;  // the differences are exact to 1e-8 of the gradient
    Matrix3d gradient;
    for (int i = 0; i < 3; ++i)
      gradient.col(i) = ((*this)(p + kStep * Vector3d::Unit(i)) - (*this)(p - kStep * Vector3d::Unit(i))) / (2 * kStep);
    return 0.5 * (gradient + gradient.transpose());
  }
};

/// Relative, root of the mean square over the volume.
struct FieldErrors {
  double displacement, strain;
};

/// The element's displacement at barycentric coordinates.
Vector3d interpolated(const Model& model, const State& state, std::size_t t, const Eigen::Vector4d& l) {
  const ElementVertices element = model.element(t);
  Vector3d u = Vector3d::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    const double at = l[static_cast<Eigen::Index>(a)];
    u += (model.is_quadratic(t) ? at * (2 * at - 1) : at) * state.displacement[element[a]];
  }
  if (model.is_quadratic(t))
    for (std::size_t m = 0; m < 6; ++m)
      u += 4 * l[static_cast<Eigen::Index>(kMidEdgeCorners[m][0])] *
           l[static_cast<Eigen::Index>(kMidEdgeCorners[m][1])] * state.displacement[element[4 + m]];
  return u;
}

FieldErrors errors_of(int cells, ElementOrder elements, const Smooth& exact) {
  const Vector3d size(0.4, 0.4, 0.4);
  Model model = solid(make_box(cells, cells, cells, size),
                      material_of(MaterialModel::st_venant_kirchhoff, 1e5, exact.nu), elements, {});
  prescribe_surface(model, size, exact);
  const State state = equilibrium(model);
  double error = 0, whole = 0, strain_error = 0, strain = 0;
  std::vector<Eigen::Vector4d> points;
  for (const VolumePoint& point : volume_points()) points.push_back(point.barycentric);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const std::vector<PointStress> found = stresses_of(model, state, t, points);
    for (std::size_t p = 0; p < points.size(); ++p) {
      Vector3d place = Vector3d::Zero();
      for (std::size_t a = 0; a < 4; ++a)
        place += points[p][static_cast<Eigen::Index>(a)] * model.rest_positions[model.tets[t][a]];
      const double weight = volume_points()[p].weight;
      error += weight * (interpolated(model, state, t, points[p]) - exact(place)).squaredNorm();
      whole += weight * exact(place).squaredNorm();
      const Matrix3d f = found[p].f;
      strain_error += weight * (0.5 * (f + f.transpose()) - Matrix3d::Identity() - exact.strain(place)).squaredNorm();
      strain += weight * exact.strain(place).squaredNorm();
    }
  }
  return {std::sqrt(error / whole), std::sqrt(strain_error / strain)};
}

struct Released {
  Model model;
  /// The displacements after 0.1 s of steps of 1/60 s, cut into `substeps`.
  std::vector<Vector3d> after(Integrator integrator, int substeps) const {
    SolverSettings settings;
    settings.integrator = integrator;
    settings.substeps = substeps;
    State state = initial_state(model);
    reference::NewtonSolver solver(model, settings);
    for (int step = 0; step < 6; ++step) solver.step(state);
    return state.displacement;
  }
};

}  // namespace

void verify_orders_in_space(Verification& verification) {
  const char* const kTest = "Orders of convergence in space";
  struct Row {
    ElementOrder elements;
    bool with_pressure;
    double displacement, strain;
    const char* truth;
  };
  const Row rows[] = {
      {ElementOrder::linear, true, 2, 1, "linear interpolation"},
      {ElementOrder::quadratic, false, 3, 2, "quadratic interpolation, where the change of volume is uniform"},
      {ElementOrder::quadratic, true, 2, 1,
       "the pressure is constant per tet (P2/P0), and the change of volume varies"}};
  Chart chart{kTest, {"cells along an edge", true, {}}, {"relative error, RMS [-]", true, {}}, {}, {}};
  int color = 0;
  for (const Row& row : rows) {
    const Smooth exact{0.3, row.with_pressure};
    const std::string which =
        std::string(name_of(row.elements)) + (row.with_pressure ? ", varying volume" : ", uniform volume");
    Series displacement{which + ": displacement", {}, color, 0, true, true},
        strain{which + ": strain", {}, color++, 1, true, true};
    std::vector<int> resolutions{2, 4, 8};
    if (verification.full) resolutions.push_back(12);
    for (const int cells : resolutions) {
      const FieldErrors errors = errors_of(cells, row.elements, exact);
      displacement.points.emplace_back(cells, errors.displacement);
      strain.points.emplace_back(cells, errors.strain);
    }
    for (const auto& [series, order] : {std::pair(&displacement, row.displacement), std::pair(&strain, row.strain)}) {
      const Eigen::Vector2d last = series->points.back(), before = *(series->points.end() - 2);
      // The last two resolutions are not infinitely fine: a tenth of the order less, and any more, passes.
      verification.add({kTest, series->name, "", std::log(before.y() / last.y()) / std::log(last.x() / before.x()),
                        0.9 * order, std::numeric_limits<double>::infinity(), number(order) + ": " + row.truth});
    }
    chart.series.push_back(std::move(displacement));
    chart.series.push_back(std::move(strain));
  }
  verification.draw(kTest, "orders_space", chart);
}

void verify_orders_in_time(Verification& verification) {
  const char* const kTest = "Orders of convergence in time";
  Released released{solid(make_box(4, 1, 1, {0.4, 0.1, 0.1}), material_of(MaterialModel::st_venant_kirchhoff, 1e5, 0.3),
                          ElementOrder::quadratic, {BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}}})};
  released.model.gravity = {0, -9.81, 0};
  const std::vector<Vector3d> exact = released.after(Integrator::sdirk2, 512);
  Chart chart{kTest, {"steps per second", true, {}}, {"relative error, RMS [-]", true, {}}, {}, {}};
  for (const IntegratorInfo& info : integrators()) {
    Series series{info.label, {}, static_cast<int>(info.integrator), 0, true, true};
    for (const int substeps : {1, 2, 4, 8, 16, 32, 64, 128}) {
      const std::vector<Vector3d> found = released.after(info.integrator, substeps);
      series.points.emplace_back(60 * substeps, relative_distance(found, exact));
    }
    const double order = std::log2((series.points.end() - 2)->y() / series.points.back().y());
    verification.add({kTest, std::string(info.label) + ", 24 quadratic tets of a released beam", "", order,
                      order_of(info.integrator) - 0.1, std::numeric_limits<double>::infinity(),
                      number(order_of(info.integrator)) + ": the integrator's, once no mode of the beam is faster than "
                                                          "a step; exact motion: SDIRK2 with 30,720 steps per second"});
    chart.series.push_back(std::move(series));
  }
  verification.draw(kTest, "orders_time", chart);
}

}  // namespace fascia
