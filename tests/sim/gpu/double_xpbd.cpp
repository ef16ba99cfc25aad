#include "tests/sim/gpu/double_xpbd.h"

#include <Eigen/Dense>

#include "sim/coloring.h"

namespace fascia::test {
namespace {

constexpr int row_of[6] = {0, 1, 2, 1, 0, 0}, column_of[6] = {0, 1, 2, 2, 2, 1};  // xx, yy, zz, yz, xz, xy

struct Shape {
  Eigen::Matrix<double, 3, 4> b;  // gradients of the shape functions
  double volume;
};

Shape shape_of(const Model& model, std::size_t tet) {
  Eigen::Matrix3d dm;
  for (int k = 0; k < 3; ++k)
    dm.col(k) = model.rest_positions[model.tets[tet][k + 1]] - model.rest_positions[model.tets[tet][0]];
  Shape shape;
  shape.b.rightCols<3>() = dm.inverse().transpose();
  shape.b.col(0) = -shape.b.rightCols<3>().rowwise().sum();
  shape.volume = dm.determinant() / 6;
  return shape;
}

Eigen::Matrix3d gradient_of(const Model& model, std::size_t tet, const Shape& shape, const std::vector<Eigen::Vector3d>& u) {
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  for (int a = 0; a < 4; ++a) f += u[model.tets[tet][a]] * shape.b.col(a).transpose();
  return f;
}

}  // namespace

DoubleXpbd::DoubleXpbd(const Model& model, const SolverSettings& settings)
    : model_(model), settings_(settings), valence_(model.rest_positions.size(), 0) {
  const std::vector<char> held = model.held();
  for (const double m : lumped_masses(model)) inv_mass_.push_back(held[inv_mass_.size()] || m <= 0 ? 0 : 1 / m);
  for (const Tet& tet : model.tets)
    for (const auto v : tet) ++valence_[v];
  seen_inv_mass_ = inv_mass_;
  if (settings.method == Method::mass_splitting)
    for (std::size_t v = 0; v < valence_.size(); ++v) seen_inv_mass_[v] *= valence_[v];
}

Vector6d DoubleXpbd::strain(std::size_t tet, const std::vector<Eigen::Vector3d>& u) const {
  const Eigen::Matrix3d f = gradient_of(model_, tet, shape_of(model_, tet), u);
  const Eigen::Matrix3d e = 0.5 * (f.transpose() * f - Eigen::Matrix3d::Identity());
  Vector6d c;
  for (int k = 0; k < 6; ++k) c[k] = e(row_of[k], column_of[k]);
  return c;
}

DoubleXpbd::TetResult DoubleXpbd::solve_tet(std::size_t t, const std::vector<Eigen::Vector3d>& u,
                                                const Vector6d& previous_strain, const Vector6d& multiplier) const {
  const Shape shape = shape_of(model_, t);
  const Eigen::Matrix3d f = gradient_of(model_, t, shape, u);
  Eigen::Matrix<double, 6, 12> g;  // d strain_k / d u_a = 1/2 (F_row b_column + F_column b_row)
  Eigen::Matrix<double, 12, 1> w;
  for (int a = 0; a < 4; ++a) {
    w.segment<3>(3 * a).setConstant(seen_inv_mass_[model_.tets[t][a]]);
    for (int k = 0; k < 6; ++k)
      g.block<1, 3>(k, 3 * a) =
          0.5 * (f.col(row_of[k]) * shape.b(column_of[k], a) + f.col(column_of[k]) * shape.b(row_of[k], a)).transpose();
  }
  const Material& m = model_.materials[model_.tet_material[t]];
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();  // U = V/2 C^T D C
  d.topLeftCorner<3, 3>().setConstant(m.lame_lambda());
  d.diagonal() += (Vector6d() << 2, 2, 2, 4, 4, 4).finished() * m.lame_mu();
  const double h = settings_.substep(), rate = m.damping / h;
  const Eigen::Matrix<double, 6, 6> alpha = (shape.volume * h * h * d).inverse();
  const Vector6d c = strain(t, u);
  const Eigen::Matrix<double, 6, 6> system = (1 + rate) * g * w.asDiagonal() * g.transpose() + alpha;
  const Vector6d change = system.ldlt().solve(-(c + rate * (c - previous_strain)) - alpha * multiplier);
  const Eigen::Matrix<double, 12, 1> dx = w.asDiagonal() * g.transpose() * change;
  TetResult result;
  result.multiplier = multiplier + change;
  for (int a = 0; a < 4; ++a) result.correction[a] = dx.segment<3>(3 * a);
  return result;
}

void DoubleXpbd::step(reference::State& state) {
  const double h = settings_.substep();
  for (int s = 0; s < settings_.substeps; ++s) {
    state.time += h;
    std::vector<Eigen::Vector3d>& u = state.displacement;
    const std::vector<Eigen::Vector3d> u_n = u;
    for (std::size_t i = 0; i < u.size(); ++i)
      if (inv_mass_[i] > 0) u[i] += h * (state.velocity[i] + h * model_.gravity);
    for (const Motion& motion : model_.motions)
      for (std::size_t k = 0; k < motion.vertices.size(); ++k) {
        const Eigen::Vector3d& rest = model_.rest_positions[motion.vertices[k]];
        u[motion.vertices[k]] = motion.position(k, rest, state.time) - rest;
      }
    std::vector<Vector6d> lambda(model_.tets.size(), Vector6d::Zero()), before;
    for (std::size_t t = 0; t < model_.tets.size(); ++t) before.push_back(strain(t, u_n));
    for (int i = 0; i < settings_.iterations && settings_.method == Method::gauss_seidel; ++i)
      for (const std::uint32_t t : color_tets(model_.tets, model_.held()).order) {
        const TetResult r = solve_tet(t, u, before[t], lambda[t]);
        lambda[t] = r.multiplier;
        for (int a = 0; a < 4; ++a) u[model_.tets[t][a]] += r.correction[a];
      }
    for (int i = 0; i < settings_.iterations && settings_.method != Method::gauss_seidel; ++i) {
      std::vector<Eigen::Vector3d> sum(u.size(), Eigen::Vector3d::Zero());
      for (std::size_t t = 0; t < model_.tets.size(); ++t) {
        const TetResult r = solve_tet(t, u, before[t], lambda[t]);
        lambda[t] = r.multiplier;
        for (int a = 0; a < 4; ++a) sum[model_.tets[t][a]] += r.correction[a];
      }
      for (std::size_t v = 0; v < u.size(); ++v)
        if (valence_[v]) u[v] += sum[v] / valence_[v];
    }
    for (std::size_t v = 0; v < u.size(); ++v) state.velocity[v] = (u[v] - u_n[v]) / h;
  }
}

}  // namespace fascia::test
