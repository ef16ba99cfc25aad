#include "sim/reference/double_xpbd.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "sim/material/signed_svd.h"
#include "sim/ordering/morton_order.h"
#include "sim/reference/elasticity.h"

namespace fascia::reference {
namespace {

constexpr int row_of[6] = {0, 1, 2, 1, 0, 0}, column_of[6] = {0, 1, 2, 2, 2, 1};  // xx, yy, zz, yz, xz, xy

struct Shape {
  Eigen::Matrix<double, 3, 4> b;  // gradients of the shape functions
  double volume;
};

Shape gradients_of(const Model& model, std::size_t tet) {
  Eigen::Matrix3d dm;
  for (int k = 0; k < 3; ++k)
    dm.col(k) = model.rest_positions[model.tets[tet][k + 1]] - model.rest_positions[model.tets[tet][0]];
  Shape shape;
  shape.b.rightCols<3>() = dm.inverse().transpose();
  shape.b.col(0) = -shape.b.rightCols<3>().rowwise().sum();
  shape.volume = dm.determinant() / 6;
  return shape;
}

using Corners = std::array<Eigen::Vector3d, 4>;

Corners corners_of(const Tet& tet, const std::vector<Eigen::Vector3d>& u) {
  return {u[tet[0]], u[tet[1]], u[tet[2]], u[tet[3]]};
}

Eigen::Matrix3d gradient_of(const Shape& shape, const Corners& u) {
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  for (int a = 0; a < 4; ++a) f += u[a] * shape.b.col(a).transpose();
  return f;
}

Vector6d green_strain_of(const Eigen::Matrix3d& f) {
  const Eigen::Matrix3d e = 0.5 * (f.transpose() * f - Eigen::Matrix3d::Identity());
  Vector6d c;
  for (int k = 0; k < 6; ++k) c[k] = e(row_of[k], column_of[k]);
  return c;
}

// F with singular values of at least 0.6, and the strain continued along the tangent below that.
void guard(Eigen::Matrix3d& f, Vector6d& c) {
  constexpr double kLeast = 0.6;
  const SignedSvd svd = signed_svd(f);
  Eigen::Vector3d slope = svd.s.cwiseMax(kLeast), e = (0.5 * (slope.cwiseAbs2().array() - 1)).matrix();
  for (int i = 0; i < 3; ++i)
    if (svd.s[i] < kLeast) e[i] += kLeast * (svd.s[i] - kLeast);
  f = svd.u * slope.asDiagonal() * svd.v.transpose();
  const Eigen::Matrix3d strain = svd.v * e.asDiagonal() * svd.v.transpose();
  for (int k = 0; k < 6; ++k) c[k] = strain(row_of[k], column_of[k]);
}

Eigen::VectorXd to_column(const std::vector<Eigen::Vector3d>& u) {
  return Eigen::Map<const Eigen::VectorXd>(u.front().data(), 3 * static_cast<Eigen::Index>(u.size()));
}

void to_vectors(const Eigen::VectorXd& x, std::vector<Eigen::Vector3d>& u) {
  Eigen::Map<Eigen::VectorXd>(u.front().data(), x.size()) = x;
}

}  // namespace

DoubleXpbd::DoubleXpbd(const Model& model, const SolverSettings& settings)
    : model_(model),
      settings_(settings),
      valence_(model.rest_positions.size(), 0),
      chebyshev_(settings.spectral_radius) {
  const std::vector<char> held = model.held();
  for (const double m : lumped_masses(model)) inv_mass_.push_back(held[inv_mass_.size()] || m <= 0 ? 0 : 1 / m);
  for (const Tet& tet : model.tets)
    for (const auto v : tet) ++valence_[v];
  seen_inv_mass_ = inv_mass_;
  if (settings.method == Method::mass_splitting)
    for (std::size_t v = 0; v < valence_.size(); ++v) seen_inv_mass_[v] *= valence_[v];
  if (settings.method != Method::gauss_seidel) return;
  coloring_ = color_tets(model.tets, held, curve_order(model.rest_positions, model.tets),
                         static_cast<std::uint32_t>(settings.colors));
  for (const std::uint32_t v : coloring_.phantom_vertex) seen_inv_mass_[v] += inv_mass_[v];
}

Vector6d DoubleXpbd::strain(std::size_t tet, const std::vector<Eigen::Vector3d>& u) const {
  return green_strain_of(gradient_of(gradients_of(model_, tet), corners_of(model_.tets[tet], u)));
}

DoubleXpbd::TetResult DoubleXpbd::solve_tet(std::size_t t, const std::vector<Eigen::Vector3d>& u,
                                            const Vector6d& previous_strain, const Vector6d& multiplier) const {
  return solve_tet(t, corners_of(model_.tets[t], u), previous_strain, multiplier);
}

DoubleXpbd::TetResult DoubleXpbd::solve_tet(std::size_t t, const Corners& u, const Vector6d& previous_strain,
                                            const Vector6d& multiplier) const {
  const Shape shape = gradients_of(model_, t);
  const Material& m = model_.materials[model_.tet_material[t]];
  Eigen::Matrix3d f = gradient_of(shape, u);
  const Vector6d plain = green_strain_of(f);
  Vector6d c = plain;
  if (m.model == MaterialModel::signed_st_venant_kirchhoff) guard(f, c);
  Eigen::Matrix<double, 6, 12> g;  // d strain_k / d u_a = 1/2 (F_row b_column + F_column b_row)
  Eigen::Matrix<double, 12, 1> w;
  for (int a = 0; a < 4; ++a) {
    w.segment<3>(3 * a).setConstant(seen_inv_mass_[model_.tets[t][a]]);
    for (int k = 0; k < 6; ++k)
      g.block<1, 3>(k, 3 * a) =
          0.5 * (f.col(row_of[k]) * shape.b(column_of[k], a) + f.col(column_of[k]) * shape.b(row_of[k], a)).transpose();
  }
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();  // U = V/2 C^T D C
  d.topLeftCorner<3, 3>().setConstant(m.lame_lambda());
  d.diagonal() += (Vector6d() << 2, 2, 2, 4, 4, 4).finished() * m.lame_mu();
  const double h = settings_.substep(), rate = m.damping / h;
  const Eigen::Matrix<double, 6, 6> alpha = (shape.volume * h * h * d).inverse();
  const Eigen::Matrix<double, 6, 6> system = (1 + rate) * g * w.asDiagonal() * g.transpose() + alpha;
  const Vector6d change = system.ldlt().solve(-(c + rate * (plain - previous_strain)) - alpha * multiplier);
  const Eigen::Matrix<double, 12, 1> dx = w.asDiagonal() * g.transpose() * change;
  TetResult result;
  result.multiplier = multiplier + change;
  for (int a = 0; a < 4; ++a) result.correction[a] = dx.segment<3>(3 * a);
  return result;
}

void DoubleXpbd::sweep(std::vector<Eigen::Vector3d>& u, std::vector<Vector6d>& lambda,
                       const std::vector<Vector6d>& before) const {
  std::vector<Eigen::Vector3d> copies = u;
  for (const std::uint32_t v : coloring_.phantom_vertex) copies.push_back(u[v]);
  if (settings_.method == Method::gauss_seidel) {
    for (const std::uint32_t t : coloring_.order) {
      std::array<Eigen::Vector3d, 4> corners;
      for (int a = 0; a < 4; ++a) corners[a] = copies[coloring_.corners[t][a]];
      const TetResult r = solve_tet(t, corners, before[t], lambda[t]);
      lambda[t] = r.multiplier;
      for (int a = 0; a < 4; ++a) copies[coloring_.corners[t][a]] += r.correction[a];
    }
    std::vector<double> count(u.size(), 1);
    for (std::size_t v = 0; v < u.size(); ++v) u[v] = copies[v];
    for (std::size_t p = 0; p < coloring_.phantom_vertex.size(); ++p) {
      u[coloring_.phantom_vertex[p]] += copies[u.size() + p];
      ++count[coloring_.phantom_vertex[p]];
    }
    for (std::size_t v = 0; v < u.size(); ++v) u[v] /= count[v];
    return;
  }
  std::vector<Eigen::Vector3d> sum(u.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < model_.tets.size(); ++t) {
    const TetResult r = solve_tet(t, u, before[t], lambda[t]);
    lambda[t] = r.multiplier;
    for (int a = 0; a < 4; ++a) sum[model_.tets[t][a]] += r.correction[a];
  }
  for (std::size_t v = 0; v < u.size(); ++v)
    if (valence_[v]) u[v] += sum[v] / valence_[v];
}

void DoubleXpbd::step(State& state) {
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
    DoubleAnderson anderson(settings_.window);
    chebyshev_.begin_step();
    for (int i = 0; i < settings_.iterations; ++i) {
      const Eigen::VectorXd x = to_column(u);
      sweep(u, lambda, before);
      if (settings_.acceleration == Acceleration::anderson_positions) to_vectors(anderson.next(x, to_column(u)), u);
      if (settings_.acceleration == Acceleration::chebyshev) to_vectors(chebyshev_.next(x, to_column(u)), u);
    }
    for (std::size_t v = 0; v < u.size(); ++v) state.velocity[v] = (u[v] - u_n[v]) / h;
  }
}

}  // namespace fascia::reference
